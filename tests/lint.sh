#!/usr/bin/env bash
# tests/lint.sh format | shell | tidy [FILE...]: one check over all files that git knows, or those given.
# Prints what is wrong, fails when anything is. tidy looks at each source alone, as nothing else does, and
# so also finds what a file forgot to include.
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

tidy_by_compile_commands() {
  on_all_cores bash -c 'tidy "$@"' tidy -p build/lint
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
  # Headers are looked at through the sources that include them.
  tidy)
    build_plugin
    find_planted
    cmake --preset lint >/dev/null
    export -f tidy
    export llvm plugin
    if [[ $# -gt 1 ]]; then
      printf '%s\0' "${@:2}" | tidy_by_compile_commands
    else
      # What is built with its boxes counted, or for pages alone, has no compile command of its own.
      git ls-files -z '*.cpp' ':!tests/lint' ':!tests/benchmarks/solver/detection_tests.cpp' \
        ':!*_serial.cpp' |
        tidy_by_compile_commands
    fi
    ;;
  *)
    echo "unknown check '${1-}'; write format, shell or tidy" >&2
    exit 2
    ;;
esac
