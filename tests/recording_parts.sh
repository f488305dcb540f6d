#!/usr/bin/env bash
# Measures what each part of the codec buys: builds its encoder without that part, in a copy of the
# sources, and puts the table into docs/recording.md. Takes about ten minutes; tests/recording.sh, which
# records the samples, comes first. Not part of run.sh.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
recordings=("$root"/out/recording/{hourglass,cylinder,small-object}.rbn)
results=$root/out/recording/parts
copy=$results/sources
rm -rf "$results"
mkdir -p "$copy"
(cd "$root" && git ls-files -z | xargs -0 cp --parents --target-directory "$copy")

codec=libribbon/recording/codec
taps=$codec/fit_weights.cpp
# What is left out, where, and the edit that leaves it out.
parts=(
  '(with all)|||'
  "bends along the ribbon|$taps|s/equations.add(taps, unit)/taps[5].fill(0), &/"
  "motion of the neighbours across, a frame ago|$taps|s/equations.add(taps, unit)/taps[3].fill(0), taps[4].fill(0), &/"
  "the column before|$taps|s/equations.add(taps, unit)/taps[6].fill(0), taps[7].fill(0), taps[8].fill(0), &/"
  "... but the particle beside|$taps|s/equations.add(taps, unit)/taps[6].fill(0), taps[8].fill(0), &/"
  "weights of the first column fitted to it alone|$taps|s/residuals, 0, 1)/residuals, 1, across)/"
  "rows that are restless counting less in the fit|$taps|s/return root \* root;/return root > 0;/"
  "four residuals in a byte|$codec/residual_runs.cpp|s/if (width <= 2) return.*/if (width == 0) return zeros;/"
  "tables of their own for short runs|libribbon/recording/coding/compression.cpp|s/symbols.size() <= short_run/false/"
)

number=0
for part in "${parts[@]}"; do
  IFS='|' read -r name file edit <<<"$part"
  if [[ -n $file ]]; then
    sed -i "$edit" "$copy/$file"
    ! cmp -s "$root/$file" "$copy/$file" || { echo "there is nothing to leave out: $name" >&2; exit 2; }
  fi
  (root=$copy build release -DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=ON -- benchmark_recording)
  "$copy/build/release/tests/benchmarks/benchmark_recording" --alone --bounds 1e-3 1e-4 1e-5 1e-6 0 \
    --json "$results/$number.json" --scratch "$results" "${recordings[@]}"
  echo "$name" >"$results/$number.name"
  [[ -z $file ]] || cp "$root/$file" "$copy/$file"
  number=$((number + 1))
done
python3 -B "$root/tests/benchmarks/table_of_parts.py" "$results" "$root/docs/recording.md"
