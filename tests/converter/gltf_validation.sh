#!/bin/sh
# Runs gltf_validation.js on samples; exit code 77 (skipped) where the validator is not installed.
#   gltf_validation.sh BLENDER_SAMPLES FOLDER NODE_MODULES
if ! [ -d "$3/gltf-validator" ] || ! command -v node >/dev/null; then
  echo "SKIPPED: gltf-validator is not in $3 (tests/run.sh installs it), so nobody has seen" \
    "whether the glTF is valid" >&2
  exit 77
fi
set -e
rm -rf "$2"
"$1" "$2"
NODE_PATH="$3" exec node "$(dirname "$0")/gltf_validation.js" "$2/spoiled_motions" "$2/textured"
