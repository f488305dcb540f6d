#!/bin/sh
# Runs a Python script in a Blender that has a window which nobody sees; exit code 77 (skipped) without Blender or Xvfb.
#   in_window.sh SCRIPT FOLDER ARGUMENT...
# FOLDER is emptied first; the script gets the arguments, must end Blender, and events are what it simulates.
for program in blender xvfb-run; do
  command -v "$program" >/dev/null || {
    echo "SKIPPED: $program is not installed" >&2
    exit 77
  }
done
script=$1
folder=$2
shift 2
rm -rf "$folder"
mkdir -p "$folder"
exec xvfb-run --auto-servernum --server-args='-screen 0 1280x800x24' \
  env LIBGL_ALWAYS_SOFTWARE=1 BLENDER_USER_RESOURCES="$folder/blender" \
  blender --factory-startup -noaudio --window-geometry 0 0 1280 800 --enable-event-simulate \
  --python-exit-code 1 --python "$script" -- "$@"
