#!/usr/bin/env bash
# Renders the pictures of one recording by an array of N Slurm tasks:
#   samples/farm/pictures.sh N RECORDING PATTERN [OPTION of ribbon-play]...
#   samples/farm/pictures.sh 8 knot.rbn 'frames/{frame:04}.png' --size 1920x1080
# Submitted again with the same words, it renders what is missing. Pixels are those of AVX2 on every machine,
# unless an option --isa says otherwise. Options for sbatch go into its variables (SBATCH_PARTITION, ...);
# ribbon-play must be found by the tasks' shells.
set -euo pipefail

if [[ $# -lt 3 || ! $1 =~ ^[1-9][0-9]*$ ]]; then
  echo "usage: $0 N RECORDING PATTERN [OPTION]..." >&2
  exit 2
fi
parts=$1 recording=$2 pattern=$3
options=("${@:4}")
[[ " ${options[*]-} " == *" --isa"[\ =]* ]] || options+=(--isa avx2)
exec sbatch --parsable --array="1-$parts" "$(dirname "${BASH_SOURCE[0]}")/task.sh" \
  ribbon-play "$recording" -o "$pattern" --resume --shard %I/%N --progress json "${options[@]}"
