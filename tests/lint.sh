#!/usr/bin/env bash
# tests/lint.sh format | shell | tidy: one check over all files that git knows. tidy needs the compile
# commands of build/release. Prints what is wrong, fails when anything is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# on_all_cores COMMAND...   A few of the files on standard input at a time.
on_all_cores() {
  xargs --null --no-run-if-empty --max-procs="$(nproc)" --max-args=2 "$@"
}

case ${1-} in
  format) git ls-files -z '*.h' '*.cpp' | on_all_cores clang-format --dry-run --Werror ;;
  shell) git ls-files -z '*.sh' .ci | on_all_cores shellcheck --external-sources ;;
  # Headers are looked at through the sources that include them. The counts of warnings in system
  # headers, which nobody sees, are left out.
  tidy)
    git ls-files -z '*.cpp' | on_all_cores clang-tidy --quiet -p build/release \
      2> >(grep --invert-match 'warnings generated' >&2)
    ;;
  *)
    echo "unknown check '${1-}'; write format, shell or tidy" >&2
    exit 2
    ;;
esac
