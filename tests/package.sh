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
  lintian --allow-root --tag-display-limit 0 --fail-on error,warning \
    --suppress-tags initial-upload-closes-no-bugs "$packages"/*.deb
}

tools_work() {
  system tools "$packages"/ribbon_*.deb bash-completion man-db
  for program in g++ cc cmake make; do
    ! inside tools sh -c "command -v $program" || fail "there is $program"
  done
  inside tools ribbon-record /usr/share/ribbon/samples/overhand-hourglass-8x400.toml -o knot.rbn --until 0.2 --quiet
  inside tools ribbon-play knot.rbn --verify --quiet
  inside tools ribbon-play knot.rbn -o 'frames/{frame:04}.png' --frames -1 --size 320x180 --quiet
  inside tools ribbon-play knot.rbn -o 'preview/{frame:04}.png' --preview --frames -1 --size 320x180 --quiet
  inside tools ribbon-convert knot.rbn -o 'out/knot.{frame:04}.fbx' --frames -1 --quiet
  inside tools ribbon-record /usr/share/ribbon/samples/gallery/bow.toml --crossings bow.svg --quiet
  inside tools ribbon-play knot.rbn -o knot.html --quiet
  inside tools ribbon-record --draw -o sketch.html --quiet
  for file in frames preview out bow.svg knot.html sketch.html; do
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

# files_of_ribbon   What lies in the system under that name, but for what dpkg and apt keep about it.
files_of_ribbon() {
  (cd "$here/development" && find . -xdev \( -path ./work -o -path ./var/lib/dpkg -o -path ./var/lib/apt -o \
    -path ./var/log -o -path ./var/cache \) -prune -o -name '*ribbon*' -print)
}

# With all packages there. (The README leads to sources, too.)
links_lead_somewhere() {
  echo "== Links of the documents"
  local documents=$here/development/usr/share/doc/ribbon
  local file link followed=0
  for file in "$documents"/docs/*.md "$documents"/libribbon/*/*.md; do
    while read -r link; do
      [[ -e $(dirname "$file")/$link ]] || fail "$file links to $link, which is not there"
      followed=$((followed + 1))
    done < <(grep --only-matching --perl-regexp '\]\(\K(?!https?:|#)[^)#]+' "$file")
  done
  [[ $followed -gt 50 ]] || fail "only $followed links were found"
}

# The same packages under an older version with a file that the newer has no more.
older_packages() {
  local package folder
  for package in ribbon libribbon-dev python3-ribbon; do
    folder=$here/older/$package
    mkdir -p "$here/older"
    rm -rf "$folder"
    dpkg-deb --raw-extract "$packages/$package"_*.deb "$folder"
    sed --in-place 's/^Version: .*/Version: 0.1.0-1/' "$folder/DEBIAN/control"
    touch "$folder/usr/share/doc/$package/of-old"
    dpkg-deb --root-owner-group --build "$folder" "$here/development/work/$package.deb" >/dev/null
  done
}

goes_up_and_away() {
  echo "== Upgrade and removal"
  older_packages
  chroot "$here/development" sh -c 'dpkg --install /work/*.deb' >"$here/dpkg.log" 2>&1
  [[ -e $here/development/usr/share/doc/ribbon/of-old ]] || fail "the older packages are not there"
  cp "$packages"/*.deb "$here/development/work"
  chroot "$here/development" sh -c 'rm /work/ribbon.deb /work/libribbon-dev.deb /work/python3-ribbon.deb
    dpkg --install /work/*.deb' >>"$here/dpkg.log" 2>&1
  [[ -z $(find "$here/development/usr" -name of-old) ]] || fail "the upgrade left something of the older packages"
  chroot "$here/development" dpkg --verify ribbon libribbon-dev python3-ribbon ||
    fail "the upgrade did not put everything in its place"
  chroot "$here/development" python3 -c 'import ribbon' # as root, Python may leave what it compiles
  chroot "$here/development" dpkg --purge python3-ribbon libribbon-dev ribbon >>"$here/dpkg.log" 2>&1
  [[ -z $(files_of_ribbon) ]] || fail "left behind: $(files_of_ribbon)"
}

looked_at_by_lintian
tools_work
completion_works
documents_are_whole
library_and_python_work
links_lead_somewhere
goes_up_and_away
echo "The packages are as they should be."
