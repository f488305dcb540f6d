#!/usr/bin/env bash
# Draws and ties knots in pages in headless Chromium as a person would; then records what was saved by
# ribbon-record, compares the bytes, and verifies the page's recording. Exit code 77 (skipped) where the
# page was not built or the browser is missing. Pictures and what was saved are left in build/sketches.
#   draw_in_browser.sh BUILD [TEST...]   (folder of a build; names as in Drawing.test_has_a_dark_face)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../.ci/setup.sh"

work=$root/build/sketches
rm -rf "$work"
mkdir -p "$work"

has_browser || { echo "SKIPPED: nobody has seen whether one can draw in pages" >&2; exit 77; }

record=$1/recorder/ribbon-record
if ! "$record" --draw -o "$work/sketch.html" 2>"$work/errors.txt"; then
  cat "$work/errors.txt" >&2
  grep -q "without Emscripten" "$work/errors.txt" || exit 1
  echo "SKIPPED: nobody has seen whether one can draw in pages" >&2
  exit 77
fi
"$record" --quiet --draw "$root/samples/overhand-cylinder-8x400.toml" \
  --set ribbon.along=100 --set ribbon.across=4 -o "$work/own.html"
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$root/tests/page/draw_in_browser.py" \
  "$work/sketch.html" "$work/own.html" "$work" "${@:2}"
[[ $# -eq 1 ]] || exit 0

cd "$work"
"$record" --quiet sketch.toml -o native.rbn
cmp native.rbn sketch.rbn
"$1/player/ribbon-play" sketch.rbn --verify
