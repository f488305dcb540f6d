#!/usr/bin/env bash
# The Debian packages as their users get them: made, looked at by lintian, installed into a Debian 12 that
# has no build tools, and used there without a network as the documents say. Exit code 77 where no root can be
# made of a folder (neither root nor user namespaces) or mmdebstrap is not installed.
#   package.sh FOLDER [PACKAGES]      PACKAGES: a folder of packages that were made before
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$1"
here=$(realpath "$1")
packages=$(realpath "${2-$here}")

fail() {
  echo "FAILED: $*"
  exit 1
}

for program in mmdebstrap lintian; do
  command -v "$program" >/dev/null || {
    echo "SKIPPED: $program is not installed"
    exit 77
  }
done
[[ $(id -u) -eq 0 ]] || {
  echo "SKIPPED: only root can enter the installed system"
  exit 77
}

[[ $# -gt 1 ]] || "$root/packaging/packages.sh" "$packages"

# system NAME PACKAGE...   A Debian with these packages, unpacked into the folder NAME.
system() {
  local folder=$here/$1
  echo "== Installing ${*:2}"
  rm -rf "$folder" && mkdir "$folder"
  "$root/packaging/container.sh" "$folder.tar" "${@:2}"
  tar --extract --file "$folder.tar" --directory "$folder" --exclude './dev/*'
  rm "$folder.tar"
  mkdir "$folder/work"
}

# inside NAME COMMAND...   Runs it there, as a user would: without a network, in a folder of its own.
inside() {
  unshare --net chroot "$here/$1" env --ignore-environment PATH=/usr/bin:/bin HOME=/work LC_ALL=C.UTF-8 \
    sh -c 'cd /work && exec "$@"' sh "${@:2}"
}

looked_at_by_lintian() {
  echo "== lintian"
  # Nobody has asked Debian to take the packages, and static libraries are what libribbon-dev is for.
  lintian --allow-root --tag-display-limit 0 --fail-on error \
    --suppress-tags initial-upload-closes-no-bugs "$packages"/*.deb
}

tools_work() {
  system tools "$packages"/ribbon_*.deb bash-completion man-db
  ! inside tools sh -c 'command -v g++ cc cmake make' || fail "there are build tools"
  inside tools ribbon-record /usr/share/ribbon/samples/overhand-hourglass-8x400.toml -o knot.rbn --until 0.2 --quiet
  inside tools ribbon-play knot.rbn --verify --quiet
  inside tools ribbon-play knot.rbn -o 'frames/{frame:04}.png' --frames -1 --size 320x180 --quiet
  inside tools ribbon-play knot.rbn -o 'preview/{frame:04}.png' --preview --frames -1 --size 320x180 --quiet
  inside tools ribbon-convert knot.rbn -o 'out/knot.{frame:04}.fbx' --frames -1 --quiet
  inside tools ribbon-record /usr/share/ribbon/samples/gallery/bow.toml --crossings bow.svg --quiet
  for file in frames preview out bow.svg; do
    [[ -s $here/tools/work/$file ]] || fail "$file is missing"
  done
  for tool in ribbon-record ribbon-play ribbon-convert; do
    inside tools man "$tool" | grep -e '--progress' >/dev/null || fail "there is no manual page of $tool"
  done
}

# completed LINE...   What bash proposes for the last word.
# shellcheck disable=SC2016  # the words are those of the shell inside
completed() {
  inside tools bash -c '
    source /usr/share/bash-completion/bash_completion
    _completion_loader "$1"
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMP_LINE="$*" COMP_POINT=${#COMP_LINE}
    _ribbon "$1"
    echo "${COMPREPLY[@]}"' bash "$@"
}

completion_works() {
  echo "== Completion"
  [[ $(completed ribbon-play --qual) == --quality ]] || fail "options are not completed"
  [[ $(completed ribbon-play --quality st) == standard ]] || fail "words of options are not completed"
  [[ $(completed ribbon-play kn) == knot.rbn ]] || fail "recordings are not completed"
  [[ -z $(completed ribbon-play --samples kn) ]] || fail "a number is completed"
}

documents_are_whole() {
  echo "== Documents"
  local documents=$here/tools/usr/share/doc/ribbon
  zgrep --quiet '^# Changelog' "$documents/changelog.gz" || fail "there is no changelog"
  [[ -e $documents/docs/gallery/bow.png && -e $documents/samples/gallery/bow.toml ]] ||
    fail "the gallery is not whole"
  cmp "$root/packaging/copyright" "$documents/copyright"
}

# The library and the module, by their documents, with the compiler that their users need.
library_and_python_work() {
  system development "$packages"/{ribbon,libribbon-dev,python3-ribbon}_*.deb g++ cmake make
  cp --recursive "$root/tests/library" "$root/tests/python" "$root/docs/library.md" "$here/development/work"
  cp "$here/tools/work/knot.rbn" "$here/development/work"
  inside development python3 library/documented_programs.py library.md programs \
    /usr/share/ribbon/samples/overhand-hourglass-8x400.toml
  inside development python3 -m unittest discover --start-directory python --pattern '*_test.py'
  inside development python3 /usr/share/ribbon/samples/tension.py knot.rbn tension.svg
  [[ -s $here/development/work/tension.svg ]] || fail "there is no plot of the tension"
}

looked_at_by_lintian
tools_work
completion_works
documents_are_whole
library_and_python_work
echo "The packages are as they should be."
