#!/bin/sh
# Runs a Python script in headless Blender; exit code 77 (skipped) where there is none.
#   in_blender.sh SCRIPT FOLDER ARGUMENT...
# FOLDER is emptied first; the script gets the arguments.
if ! command -v blender >/dev/null; then
  echo "SKIPPED: Blender is not installed, so nobody has seen whether it opens the exports" >&2
  exit 77
fi
script=$1
folder=$2
shift 2
rm -rf "$folder"
mkdir -p "$folder"
# Blender keeps settings and scratch files in the user's folders; a test leaves them alone.
exec env BLENDER_USER_RESOURCES="$folder/blender" blender -b --factory-startup -noaudio \
  --python-exit-code 1 --python "$script" -- "$@"
