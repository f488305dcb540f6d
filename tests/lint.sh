#!/usr/bin/env bash
# tests/lint.sh format | shell | tidy [FILE...] | tidy-all: one check over all files that git knows, or
# those given; tidy without files over all but tests, and without the analyzer, which takes a third of the
# time. Needs the compile commands of build/release, and tidy-all those of build/sanitize as well. Prints what is wrong, fails when anything is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The release whose findings the code is clean of; its plugins must be built for the same one.
llvm=14
plugin=build/lint/own_declarations.so

# on_all_cores COMMAND...   A few of the files on standard input at a time.
on_all_cores() {
  xargs --null --no-run-if-empty --max-procs="$(nproc)" --max-args=2 "$@"
}

build_plugin() {
  [[ ! $plugin -nt tests/lint/own_declarations.cpp ]] || return 0
  mkdir -p "$(dirname "$plugin")"
  g++ -std=c++17 -O1 -fPIC -fno-rtti -shared -isystem "/usr/lib/llvm-$llvm/include" \
    tests/lint/own_declarations.cpp -o "$plugin"
}

# The counts of warnings in system headers, which nobody sees, are left out.
tidy() {
  "clang-tidy-$llvm" --load="$plugin" --quiet "$@" 2> >(grep --invert-match 'warnings generated' >&2)
}

# tidy_by BUILD OPTION...   By the compile commands of a build.
tidy_by() {
  on_all_cores bash -c 'tidy "$@"' tidy -p "build/$1" "${@:2}"
}

# A lint that finds nothing anywhere would look just like clean code.
find_planted() {
  local finding found
  found=$(tidy tests/lint/planted.cpp -- -std=c++20 || true)
  for finding in readability-identifier-naming bugprone-use-after-move \
    clang-analyzer-core.DivideZero; do
    grep --quiet "$finding" <<<"$found" || {
      echo "the lint no longer finds $finding in tests/lint/planted.cpp" >&2
      return 1
    }
  done
}

case ${1-} in
  format) git ls-files -z '*.h' '*.cpp' | on_all_cores clang-format --dry-run --Werror ;;
  shell) git ls-files -z '*.sh' .ci | on_all_cores shellcheck --external-sources ;;
  # Headers are looked at through the sources that include them. Fuzz targets are built with the
  # sanitizers only.
  tidy | tidy-all)
    build_plugin
    find_planted
    export -f tidy
    export llvm plugin
    if [[ $# -gt 1 ]]; then
      printf '%s\0' "${@:2}" | tidy_by release
    elif [[ $1 == tidy ]]; then
      git ls-files -z '*.cpp' ':!tests' | tidy_by release '--checks=-clang-analyzer-*'
    else
      status=0
      git ls-files -z '*.cpp' ':!tests/lint' ':!tests/fuzz' | tidy_by release || status=$?
      git ls-files -z 'tests/fuzz/*.cpp' | tidy_by sanitize || status=$?
      exit "$status"
    fi
    ;;
  *)
    echo "unknown check '${1-}'; write format, shell, tidy or tidy-all" >&2
    exit 2
    ;;
esac
