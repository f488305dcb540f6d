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
lines=$(grep --count --invert-match --extended-regexp '^[[:space:]]*(#|$)' "$2") || {
  echo "$2 has no line with a name and settings" >&2
  exit 2
}
exec sbatch --parsable --array="1-$lines" "$here/task.sh" "$here/record_line.sh" "$1" "$2" "$3" %I
