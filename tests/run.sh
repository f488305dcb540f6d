#!/usr/bin/env bash
# What must hold before a change goes in: installs what is missing, builds in Release, runs the tests,
# runs those again under the sanitizers that take in what others wrote (scenes, drawings, meshes,
# recordings, command lines), checks format and shell scripts. Ends with one line "N passed, N failed";
# fails when that is not 0. Takes 8 to 15 minutes on two quiet cores, by their speed.
#   --quick   only the Release build and its tests
#   --all     benchmarks, the module for Python and packages as well, nearly all tests under the sanitizers,
#             lint: two hours
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

case ${1-} in
  '' | --quick | --all) ;;
  *)
    echo "unknown option '$1'; write --quick, --all or nothing" >&2
    exit 2
    ;;
esac

passed=0
failed=0
skipped=0

finish() {
  local status=$?
  # Something could not even be tried.
  [[ $status -eq 0 || $failed -gt 0 ]] || failed=1
  [[ $skipped -eq 0 ]] || echo "$skipped tests were skipped; their reasons stand above"
  echo "$passed passed, $failed failed"
  [[ $failed -eq 0 ]] || exit 1
}
trap finish EXIT

# The value of an attribute of ctest's summary.
reported() { grep --max-count=1 --only-matching --perl-regexp "\s$1=\"\K[0-9]+" "$2"; }

# run_ctest PRESET CTEST_OPTION...
run_ctest() {
  local preset=$1 status=0 report failures skips
  report=$root/build/$preset/test-report.xml
  rm -f "$report"
  (cd "$root" && ctest --preset "$preset" --parallel "$(nproc)" \
    --output-junit "$report" "${@:2}") || status=$?
  failures=$(reported failures "$report")
  skips=$(reported skipped "$report")
  # What ctest could not run is no failure to its report, but it is to us.
  [[ $status -eq 0 || $failures -gt 0 ]] || failures=1
  failed=$((failed + failures))
  skipped=$((skipped + skips))
  passed=$((passed + $(reported tests "$report") - failures - skips))
}

# check WHAT COMMAND...   A command that cannot be tried here ends with 77 and says why.
check() {
  local status=0
  echo "== Checking $1"
  "${@:2}" || status=$?
  case $status in
    0) passed=$((passed + 1)) ;;
    77) skipped=$((skipped + 1)) ;;
    *)
      echo "FAILED: $1"
      failed=$((failed + 1))
      ;;
  esac
}

# Under the sanitizers: never the finer samples, which take the same paths as others, nor the mutation
# tests, whose whole runs judge the oracles. What GoogleTest adds to names of tests with parameters comes
# after them.
left_out='Sample.*_(16|32)x[0-9]+|^mutation'
release=(-DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=OFF -DRIBBON_BUILD_PYTHON=OFF)
sanitize=(-DRIBBON_TEST_EVERY_STATION=OFF)
if [[ ${1-} == --all ]]; then
  release=(-DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=ON -DRIBBON_BUILD_PYTHON=ON)
  sanitize=(-DRIBBON_TEST_EVERY_STATION=ON)
fi

install_missing "${build_packages[@]}" "${test_packages[@]}"
[[ ${1-} != --all ]] || install_missing "${python_packages[@]}"
install_gltf_validator
if [[ ${1-} == --all ]]; then
  # Without them what needs them says so.
  { install_page_tools && install_missing "${browser_packages[@]}"; } || true
fi
build release "${release[@]}"
run_ctest release
[[ ${1-} != --quick ]] || exit 0
build sanitize "${sanitize[@]}" -- tests
run_ctest sanitize --exclude-regex "$left_out"
check "format" "$root/tests/lint.sh" format
check "shell scripts" "$root/tests/lint.sh" shell
if [[ ${1-} == --all ]]; then
  check "lint" "$root/tests/lint.sh" tidy
  install_missing "${farm_packages[@]}" "${package_packages[@]}" || true # without them those tests say so
  check "the same bits in WebAssembly" "$root/tests/page/same_bits.sh" "$root/build/release"
  check "pages in a browser" "$root/tests/page/in_browser.sh" "$root/build/release"
  check "drawing in a browser" "$root/tests/page/draw_in_browser.sh" "$root/build/release"
  check "farm" "$root/tests/farm/slurm.sh" "$root/build/release" "$root/build/farm"
  check "packages" "$root/tests/package.sh" "$root/build/packaged"
fi
