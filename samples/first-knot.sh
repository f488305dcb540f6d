#!/usr/bin/env bash
# From a fresh Debian 12 and this clone to the first knot: installs what is missing, builds, records a
# ribbon fastening round an hourglass, draws it and exports it. Run again, it reuses the build.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

scene=$root/samples/overhand-hourglass-8x400.toml
out=$root/out/first-knot
every_tenth=::10

install_missing "${build_packages[@]}"
build release -DRIBBON_BUILD_TESTS=OFF -- ribbon-record ribbon-play ribbon-convert

tools=$root/build/release
echo "== Recording"
"$tools/recorder/ribbon-record" "$scene" --force -o "$out/knot.rbn"
echo "== Drawing"
"$tools/player/ribbon-play" "$out/knot.rbn" -o "$out/frames/{frame:04}.png" --frames "$every_tenth" --force
"$tools/player/ribbon-play" "$out/knot.rbn" --sheet "$out/sheet.png" --force
echo "== Exporting"
for format in obj fbx; do
  "$tools/converter/ribbon-convert" "$out/knot.rbn" --force -o "$out/$format/knot.{frame:04}.$format" \
    --frames "$every_tenth"
done
"$tools/converter/ribbon-convert" "$out/knot.rbn" --force -o "$out/knot.pc2"

cat <<END

Recording          $out/knot.rbn
Pictures           $out/frames/
All at a glance    $out/sheet.png
Models             $out/obj/, $out/fbx/
Motion in one file $out/knot.pc2
END
