#!/usr/bin/env bash
# Draws and ties knots in pages in Chromium and in Firefox as a person would; then records what was saved
# by ribbon-record, compares the bytes, and verifies the page's recording. Exit code 77 (skipped) where the
# page was not built or a browser is missing. Pictures and what was saved are left in build/sketches.
#   [BROWSERS=firefox] draw_in_browser.sh BUILD [TEST...]   (folder of a build; names as in
#                                                            Drawing.test_keys_draw_exchange_and_tie)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../.ci/setup.sh"

work=$root/build/sketches
rm -rf "$work"
mkdir -p "$work"

has_browsers || { echo "SKIPPED: nobody has seen whether one can draw in pages" >&2; exit 77; }

record=$1/recorder/ribbon-record
if ! "$record" --draw -o "$work/sketch.html" 2>"$work/errors.txt"; then
  cat "$work/errors.txt" >&2
  grep -q "without Emscripten" "$work/errors.txt" || exit 1
  echo "SKIPPED: nobody has seen whether one can draw in pages" >&2
  exit 77
fi
"$record" --quiet --draw "$root/samples/overhand-cylinder-8x400.toml" \
  --set ribbon.along=100 --set ribbon.across=4 -o "$work/own.html"
"$record" --quiet --draw "$root/samples/gallery/reef.toml" -o "$work/reef.html"
sed 's|transform="translate|transform="scale(0.001) translate|' "$root/samples/overhand-cylinder.svg" >"$work/metres.svg"
sed "s|overhand-cylinder.svg\"|metres.svg\"\nunit = 1.0|;s|cylinder.obj|$root/samples/cylinder.obj|" \
  "$root/samples/overhand-cylinder-8x400.toml" >"$work/metres.toml"
"$record" --quiet --draw "$work/metres.toml" -o "$work/metres.html"
build=$(realpath "$1")
for browser in ${BROWSERS:-chromium firefox}; do
  mkdir "$work/$browser"
  in_browser "$browser" "$root/tests/page/draw_in_browser.py" \
    "$work" "$work/$browser" "${@:2}"
  [[ $# -eq 1 ]] || continue
  (
    cd "$work/$browser"
    "$build/recorder/ribbon-record" --quiet sketch.toml -o native.rbn
    cmp native.rbn sketch.rbn
    "$build/player/ribbon-play" sketch.rbn --verify
    frames=$("$build/player/ribbon-play" behind/sketch.rbn --info | sed -n 's/^frames *\([0-9]*\) .*/\1/p')
    "$build/recorder/ribbon-record" --quiet behind/sketch.toml -o behind/native.rbn --frames "$frames"
    # Stopped in the page, at a limit here: which one the directory tells, behind all else.
    directory=$(tail --bytes 16 behind/native.rbn | od -A n -t u8 -N 8)
    cmp --bytes="${directory// /}" behind/native.rbn behind/sketch.rbn
    mkdir native
    "$build/converter/ribbon-convert" --quiet sketch.rbn -o native/sketch.glb
    "$build/converter/ribbon-convert" --quiet sketch.rbn --frames -1 -o native/sketch.obj
    for file in sketch.glb sketch.obj sketch.mtl; do cmp "native/$file" "$file"; done
  )
done
