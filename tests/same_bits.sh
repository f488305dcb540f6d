#!/usr/bin/env bash
# Recordings are read and written alike everywhere: builds the codec by both compilers, without
# optimisation, for any x86-64 processor and for this one, and runs the tests that compare bits, each
# with all instruction sets that the codec can choose from here. Runs come to the same bits, too: builds
# the simulation without Eigen's vector instructions, as a processor without any would have it, and as
# WebAssembly, whose recordings are compared byte by byte. Takes some minutes of one core. Not part of run.sh, which compares two of these builds.
#   --simulation   only the latter
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"

# compare STATION COMPILER FLAGS TESTS
compare() {
  local folder=$root/build/same-bits/$2${3// /}
  echo "== $1 $2 $3"
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS="$3" -DRIBBON_BUILD_BENCHMARKS=OFF >/dev/null
  cmake --build "$folder" --parallel "$(nproc)" --target "test_$1" >/dev/null
  "$folder/tests/$1/test_$1" --gtest_brief=1 --gtest_filter="$4"
}

for station in geometry ribbon_mesh simulation; do
  compare "$station" g++ "-O2 -DEIGEN_DONT_VECTORIZE" '*SameBits*:*same_bits*'
done
if install_page_tools; then
  build release -DRIBBON_BUILD_TESTS=ON -- ribbon-record decoded_frames
  "$root/tests/page/same_bits.sh" "$root/build/release"
else
  echo "SKIPPED: without Emscripten nobody has seen whether pages come to the same bits" >&2
fi
[[ ${1-} != --simulation ]] || exit 0
for compiler in g++ clang++; do
  for flags in -O0 "-O3 -march=x86-64" "-O3 -march=native" "-O2 -march=x86-64-v3"; do
    compare recording "$compiler" "$flags" '*SameBits*:*Golden*:PositionCodec*'
  done
done
