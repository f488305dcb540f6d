#!/usr/bin/env bash
#SBATCH --job-name=ribbon
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=%x-%A_%a.log
#SBATCH --signal=B:TERM@60
# One task of a Slurm array: runs the command that it is given, with %I and %N in it replaced by the
# task's number, from 1, and by how many there are. Where the command was interrupted, found the disk full
# (exit code 3) or was killed, it asks Slurm to queue the task again; the command must go on where it
# stopped. Other exit codes are the task's.
set -uo pipefail

most_restarts=20

if [[ $((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1)) -ne $SLURM_ARRAY_TASK_COUNT ]]; then
  echo "the array has gaps; write --array=1-N, tasks that are complete end at once" >&2
  exit 2
fi
words=("${@//%I/$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))}")
words=("${words[@]//%N/$SLURM_ARRAY_TASK_COUNT}")

# In the background, so that a signal (the time is nearly up) reaches this script and is passed on.
"${words[@]}" &
command=$!
trap 'kill -TERM "$command"' TERM
wait "$command"
status=$?
while kill -0 "$command" 2>/dev/null; do
  wait "$command"
  status=$?
done

if [[ $status -eq 3 || $status -gt 128 ]] && [[ ${SLURM_RESTART_COUNT:-0} -lt $most_restarts ]]; then
  echo "ended with $status; asks to be queued again"
  scontrol requeue "$SLURM_JOB_ID" && sleep infinity # until Slurm ends it
fi
exit "$status"
