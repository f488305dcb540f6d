#!/usr/bin/env bash
# Plays pages in Chromium and in Firefox as a person would. Exit code 77 (skipped) where the page was not
# built or a browser is missing. Pictures of what was seen are left in build/page-pictures.
#   [BROWSERS=firefox] in_browser.sh BUILD [TEST...]   (folder of a build; names as in Page.test_fits_a_phone)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../.ci/setup.sh"

work=$root/build/page-pictures
mkdir -p "$work"

has_browsers || { echo "SKIPPED: nobody has seen whether pages play" >&2; exit 77; }

# make NAME SCENE OPTION...   What an older recorder made, or of an older scene, is made anew.
make() {
  [[ $work/$1.rbn -nt $build/recorder/ribbon-record && $work/$1.rbn -nt $root/samples/$2 &&
    $work/$1.rbn -nt ${BASH_SOURCE[0]} ]] ||
    "$build/recorder/ribbon-record" --quiet --force "$root/samples/$2" -o "$work/$1.rbn" "${@:3}"
}

build=$1
make knot overhand-hourglass-8x400.toml --set ribbon.along=200 --set ribbon.across=4
make other overhand-cylinder-8x400.toml --set ribbon.along=100 --set ribbon.across=3 --set time.duration=2
make fine overhand-hourglass-8x400.toml --set ribbon.across=16 --frames 100
if ! "$build/player/ribbon-play" "$work/knot.rbn" -o "$work/knot.html" --force 2>"$work/errors.txt"; then
  cat "$work/errors.txt" >&2
  grep -q "without Emscripten" "$work/errors.txt" || exit 1
  echo "SKIPPED: nobody has seen whether pages play" >&2
  exit 77
fi
for browser in ${BROWSERS:-chromium firefox}; do
  in_browser "$browser" "$root/tests/page/in_browser.py" \
    "$work/knot.html" "$work/knot.rbn" "$work/other.rbn" "$work/fine.rbn" "$work/$browser" "${@:2}"
done
