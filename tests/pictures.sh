#!/usr/bin/env bash
# Records the samples, renders frames of them with few and with many samples in a pixel, and puts the
# tables and the plot of what quality costs and of what --noise reaches into docs/play.md and
# docs/play.svg. Takes four minutes on two idle cores; one that was stopped goes on where it was, as
# long as player and recordings are the same. Not part of run.sh.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
build release -DRIBBON_BUILD_TESTS=OFF -- ribbon-record ribbon-play
results=$root/out/pictures
mkdir -p "$results"

# Until they are tight, but for the largest.
recordings=()
for scene in "$root"/samples/*.toml "$root/samples/gallery/granny.toml"; do
  recording=$results/$(basename "$scene" .toml).rbn
  limit=()
  [[ $scene != *32x800* ]] || limit=(--frames 100)
  [[ -e $recording ]] || "$root/build/release/recorder/ribbon-record" --quiet \
    "$scene" --output "$recording" "${limit[@]}"
  recordings+=("$recording")
done
play=$root/build/release/player/ribbon-play
kept=$results/measured.txt
python3 -B "$root/tests/benchmarks/picture_noise.py" "$play" "$root/docs/play.md" "$kept" \
  "${recordings[@]}"
python3 -B "$root/tests/benchmarks/picture_quality.py" "$play" "$root/docs/play.md" "$root/docs/play.svg" "$kept" \
  "$results"/overhand-{hourglass-8x400,small-object-16x400}.rbn
