#!/bin/sh
# Runs blender_import.py in headless Blender; exit code 77 (skipped) where there is none.
#   blender_import.sh RIBBON_CONVERT BLENDER_SAMPLES FOLDER
if ! command -v blender >/dev/null; then
  echo "SKIPPED: Blender is not installed, so nobody has seen whether it opens the exports" >&2
  exit 77
fi
rm -rf "$3"
# Blender keeps settings and scratch files in the user's folders; a test leaves them alone.
exec env BLENDER_USER_RESOURCES="$3/blender" blender -b --factory-startup -noaudio \
  --python-exit-code 1 --python "$(dirname "$0")/blender_import.py" -- "$@"
