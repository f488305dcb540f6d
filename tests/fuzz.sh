#!/usr/bin/env bash
# Fuzzes the codec and the readers of recordings, scenes, drawings and meshes for longer than run.sh does.
#   tests/fuzz.sh [SECONDS]      for each target, 600 unless said otherwise
#   tests/fuzz.sh --corpus       writes tests/fuzz/corpus anew, when the format has changed
# Stops at the first finding, whose input is then kept in out/fuzz, as is what makes a target go new
# ways.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
targets=(round_trip hostile_geometry recording_file scene_text drawing_file mesh_file)
build sanitize -- "${targets[@]/#/fuzz_}" fuzz_corpus
programs=$root/build/sanitize/tests/fuzz
corpus=$root/tests/fuzz/corpus

if [[ ${1-} == --corpus ]]; then
  rm -rf "$corpus"
  "$programs/fuzz_corpus" "$corpus"
  exit
fi
declare -A seeds=([scene_text]=$root/samples [drawing_file]=$root/samples)
for target in "${targets[@]}"; do
  found=$root/out/fuzz/$target
  mkdir -p "$found"
  echo "== Fuzzing $target"
  "$programs/fuzz_$target" -max_total_time="${1-600}" -max_len=8192 -timeout=10 \
    -rss_limit_mb=1500 -malloc_limit_mb=400 -verbosity=0 -print_final_stats=1 \
    -artifact_prefix="$found-" "$found" "${seeds[$target]-$corpus/$target}"
done
