#!/usr/bin/env bash
# Records one scene with many settings, by a Slurm array with a task for each line of a sweep:
#   samples/farm/sweep.sh SCENE SWEEP FOLDER
#   samples/farm/sweep.sh samples/overhand-cylinder-8x400.toml samples/farm/sweep.txt out/sweep
# A line of SWEEP is a name and settings, as in 'fast fastening.speed=0.3'; NAME.rbn goes into FOLDER.
# Submitted again, it goes on with recordings that are not finished, and leaves finished ones alone.
set -euo pipefail

if [[ $# -ne 3 ]]; then
  echo "usage: $0 SCENE SWEEP FOLDER" >&2
  exit 2
fi
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")

refuse() {
  echo "$*" >&2
  exit 2
}

[[ -r $2 ]] || refuse "$2: cannot be read; name the sweep's file"
declare -A names=()
while read -r -a words || [[ ${#words[@]} -gt 0 ]]; do
  [[ ${#words[@]} -gt 0 && ${words[0]} != '#'* ]] || continue
  [[ ${words[*]} != *$'\r'* ]] || refuse "$2: its lines end as on Windows; convert it by dos2unix"
  name=${words[0]}
  [[ -z ${names[$name]-} ]] || refuse "$2: the name '$name' comes twice; give each line one of its own"
  names[$name]=taken
  for setting in "${words[@]:1}"; do
    [[ $setting == ?*=?* ]] || refuse "$2: $name: '$setting' is no setting; write KEY=VALUE without spaces"
  done
done <"$2"
[[ ${#names[@]} -gt 0 ]] || refuse "$2: it has no line with a name and settings"
exec sbatch --parsable --array="1-${#names[@]}" "$here/task.sh" "$here/record_line.sh" "$1" "$2" "$3" %I
