#!/usr/bin/env bash
# Records a scene with the settings of line I of a sweep, or goes on with that recording:
#   record_line.sh SCENE SWEEP FOLDER I
set -euo pipefail

scene=$1 sweep=$2 folder=$3 number=$4
line=$(grep --invert-match --extended-regexp '^[[:space:]]*(#|$)' "$sweep" | sed --quiet "${number}p")
read -r -a words <<<"$line"
recording=$folder/${words[0]}.rbn
settings=()
for setting in "${words[@]:1}"; do settings+=(--set "$setting"); done
# An empty file was killed before it held anything. All else is gone on with or refused, never replaced.
if [[ -s $recording ]]; then
  exec ribbon-record --resume "$recording" --progress json
fi
exec ribbon-record "$scene" "${settings[@]}" -o "$recording" --force --progress json
