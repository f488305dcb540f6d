#!/usr/bin/env bash
# Runs in WebAssembly come to the bits of native ones: records samples by ribbon-record with each
# integrator, records them again under Node by the same code compiled by Emscripten, and compares the
# files byte by byte; then compares what both decode. Some minutes of one core. Exit code 77 (skipped) where Emscripten is missing.
#   same_bits.sh BUILD   (folder of a build with tests)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../.ci/setup.sh"

record=$1/recorder/ribbon-record
decode=$1/tests/page/decoded_frames
work=$root/build/page-same-bits
programs=$root/build/page/tests/page

if ! command -v emcc >/dev/null || ! command -v node >/dev/null; then
  echo "SKIPPED: emcc or node is missing (install_page_tools of .ci/setup.sh installs emcc), so nobody" \
    "has seen whether pages come to the same bits" >&2
  exit 77
fi
build page -- record_again decoded_frames sketch >/dev/null

rm -rf "$work"
mkdir -p "$work"
cp -r "$root/samples" "$work/samples"
different=0

# same FRAMES SCENE SETTING...   The recording lies beside the scene, where its drawing is found again.
same() {
  local native=$work/samples/$2.rbn page=$work/samples/$2.page.rbn settings=() setting
  for setting in "${@:3}"; do settings+=(--set "$setting"); done
  "$record" --quiet --force "$work/samples/$2" -o "$native" --frames "$1" "${settings[@]}"
  node "$programs/record_again.js" "$native" "$page"
  "$decode" "$native" >"$work/native.txt"
  node "$programs/decoded_frames.js" "$native" >"$work/page.txt"
  if cmp "$native" "$page" && cmp "$work/native.txt" "$work/page.txt"; then
    echo "the same bytes, $(stat --format %s "$native"): $*"
  else
    echo "DIFFERENT: $*"
    different=1
  fi
}

coarse=(ribbon.along=200 ribbon.across=4)
for integrator in symplectic_euler rk4 implicit; do
  same 150 overhand-hourglass-8x400.toml "${coarse[@]}" "time.integrator=$integrator"
done
same 150 overhand-small-object-8x400.toml "${coarse[@]}"
same 60 overhand-hanging-8x400.toml "${coarse[@]}"
same 60 overhand-hanging-8x400.toml "${coarse[@]}" time.integrator=implicit
same 40 overhand-cylinder-8x400.toml
same 10 gallery/bow.toml
same 40 gallery/tapered.toml
# Hands that hold from the first step on, and one that carries from the sixth on.
for integrator in symplectic_euler implicit; do
  same 15 gallery/windsor.toml "time.integrator=$integrator"
  same 15 gallery/cravat.toml 'stage[1].at_most=0.05' "time.integrator=$integrator"
done

# The page in which one draws, without a browser: what it would save is recorded once more.
mkdir "$work/sketch"
cp "$root/samples/cylinder.obj" "$work/sketch"
"$1/recorder/pack_scenes" "$work/scenes.json" "$root/recorder/page/scenes/cylinder.toml"
node "$root/tests/page/tie_in_node.js" "$work/scenes.json" "$work/sketch"
"$record" --quiet "$work/sketch/sketch.toml" -o "$work/sketch/native.rbn"
if ! cmp "$work/sketch/page.rbn" "$work/sketch/native.rbn"; then
  echo "DIFFERENT: what the page ties"
  different=1
fi
# Likewise what it hands out besides; and its object is read as the same vertices.
"$1/converter/ribbon-convert" --quiet "$work/sketch/page.rbn" -o "$work/sketch/native.glb"
"$1/converter/ribbon-convert" --quiet "$work/sketch/page.rbn" --frames -1 -o "$work/sketch/native.obj"
sed -i 's/^mtllib native.mtl$/mtllib page.mtl/' "$work/sketch/native.obj"
for kind in obj mtl glb; do
  if ! cmp "$work/sketch/page.$kind" "$work/sketch/native.$kind"; then
    echo "DIFFERENT: the page's .$kind"
    different=1
  fi
done
"$record" --quiet "$work/sketch/sketch.toml" --set 'obstacle.mesh="page-object.obj"' --frames 2 \
  -o "$work/sketch/object.rbn"
"$record" --quiet "$work/sketch/sketch.toml" --frames 2 -o "$work/sketch/first.rbn"
"$decode" "$work/sketch/object.rbn" >"$work/native.txt"
"$decode" "$work/sketch/first.rbn" >"$work/page.txt"
if ! cmp "$work/native.txt" "$work/page.txt"; then
  echo "DIFFERENT: a run round the page's object"
  different=1
fi
exit "$different"
