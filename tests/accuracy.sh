#!/usr/bin/env bash
# Measures the levels of accuracy and single settings around them, puts the table into docs/accuracy.md
# and draws docs/accuracy.svg. Takes some minutes of one core. Not part of run.sh.
#   tests/accuracy.sh [OPTION...]    options are handed to benchmark_accuracy
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
build release -DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=ON -- benchmark_accuracy
results=$root/out/accuracy
mkdir -p "$results"
status=0
"$root/build/release/tests/benchmarks/benchmark_accuracy" --json "$results/figures.json" "$@" |
  tee "$results/table.txt" || status=$?
[[ $status -le 1 ]] || exit "$status"
python3 -B "$root/tests/benchmarks/plot_accuracy.py" "$results/figures.json" "$results/table.txt" \
  "$root/docs/accuracy.md" "$root/docs/accuracy.svg"
exit "$status"
