#!/usr/bin/env bash
# Records the three samples of 16 x 400 particles exactly, measures what a recording of them costs at
# several bounds beside other codecs, and puts tables and plot into docs/recording.md and
# docs/recording.svg. Takes about five minutes. Not part of run.sh.
#   tests/recording.sh [OPTION...]    options are handed to benchmark_recording
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
build release -DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=ON -- ribbon-record benchmark_recording
results=$root/out/recording
mkdir -p "$results"

recordings=()
for sample in hourglass cylinder small-object; do
  scene=$results/$sample.toml
  sed "s|\"overhand-$sample.svg\"|\"$root/samples/overhand-$sample.svg\"|
    s|\"$sample.obj\"|\"$root/samples/$sample.obj\"|" \
    "$root/samples/overhand-$sample-16x400.toml" >"$scene"
  printf '\n[recording]\nframes_per_second = 60\nmax_position_error = 0\n' >>"$scene"
  recording=$results/$sample.rbn
  "$root/build/release/recorder/ribbon-record" --quiet --force "$scene" --output "$recording"
  recordings+=("$recording")
done

status=0
"$root/build/release/tests/benchmarks/benchmark_recording" --json "$results/figures.json" \
  --scratch "$results" "$@" "${recordings[@]}" || status=$?
[[ $status -le 1 ]] || exit "$status"
python3 -B "$root/tests/benchmarks/plot_recording.py" "$results/figures.json" \
  "$root/docs/recording.md" "$root/docs/recording.svg"
exit "$status"
