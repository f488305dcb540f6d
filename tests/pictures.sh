#!/usr/bin/env bash
# Records two samples, renders frames of them with few and with many samples, and puts the table and
# the plot of what quality costs into docs/play.md and docs/play.svg. Takes about ten minutes. Not
# part of run.sh.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
build release -DRIBBON_BUILD_TESTS=OFF -- ribbon-record ribbon-play
results=$root/out/pictures
mkdir -p "$results"

recordings=()
for sample in overhand-hourglass-8x400 overhand-small-object-16x400; do
  recording=$results/$sample.rbn
  [[ -e $recording ]] || "$root/build/release/recorder/ribbon-record" --quiet \
    "$root/samples/$sample.toml" --output "$recording"
  recordings+=("$recording")
done
python3 -B "$root/tests/benchmarks/picture_quality.py" "$root/build/release/player/ribbon-play" \
  "$root/docs/play.md" "$root/docs/play.svg" "${recordings[@]}"
