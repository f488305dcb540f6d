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
if [[ -s $recording ]]; then
  told=$(ribbon-play --info "$recording")
  # What was killed before its first checkpoint, or even before it held anything, is of no use yet. All else is
  # gone on with or refused, never replaced.
  if ! grep --quiet '^checkpoints *none$' <<<"$told" || ! grep --quiet '^frames *[01] ' <<<"$told"; then
    # Behind those of the line it tells what its fabric amounts to, as "key = value".
    recorded=$(sed --quiet --regexp-extended 's/^begun .*, with / /; T; s/ [^ ]+ = [^ ]+//g; s/^ //p' <<<"$told")
    if [[ $recorded != "${words[*]:1}" ]]; then
      echo "$recording: was recorded with '$recorded', not with '${words[*]:1}'; choose another name or folder" >&2
      exit 2
    fi
    exec ribbon-record --resume "$recording" --progress json
  fi
fi
exec ribbon-record "$scene" "${settings[@]}" -o "$recording" --force --progress json
