#!/usr/bin/env bash
# Recordings are read and written alike everywhere: builds the codec by both compilers, without
# optimisation, for any x86-64 processor and for this one, and runs the tests that compare bits, each
# with all instruction sets that the codec can choose from here. Takes some minutes of one core. Not part
# of run.sh, which compares two of these builds.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"

# compare COMPILER FLAGS
compare() {
  local folder=$root/build/same-bits/$1${2// /}
  echo "== $1 $2"
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_COMPILER="$1" \
    -DCMAKE_CXX_FLAGS="$2" -DRIBBON_BUILD_BENCHMARKS=OFF >/dev/null
  cmake --build "$folder" --parallel "$(nproc)" --target test_recording >/dev/null
  "$folder/tests/recording/test_recording" --gtest_brief=1 \
    --gtest_filter='*SameBits*:*Golden*:PositionCodec*'
}

for compiler in g++ clang++; do
  for flags in -O0 "-O3 -march=x86-64" "-O3 -march=native" "-O2 -march=x86-64-v3"; do
    compare "$compiler" "$flags"
  done
done
