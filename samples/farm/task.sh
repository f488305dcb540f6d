#!/usr/bin/env bash
#SBATCH --job-name=ribbon
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=%x-%A_%a.log
#SBATCH --signal=B:TERM@60
# One task of a Slurm array: runs the command that it is given; its words %I and %I/%N become the task's
# number, from 1, and that of how many. Where the command was interrupted or found the disk full (exit
# code 3), or was ended by TERM, KILL or XCPU, it asks Slurm to queue the task again, unless that is being
# cancelled; the command must go on where it stopped. Other exit codes, and crashes, are the task's.
set -uo pipefail

most_restarts=20

if [[ $((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1)) -ne $SLURM_ARRAY_TASK_COUNT ]]; then
  echo "the array has gaps; write --array=1-N, tasks that are complete end at once" >&2
  exit 2
fi
# Not the job's own number, which for one of the tasks is also that of the whole array.
task=${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID
number=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))
words=()
for word in "$@"; do
  case $word in
    %I) word=$number ;;
    %I/%N) word=$number/$SLURM_ARRAY_TASK_COUNT ;;
  esac
  words+=("$word")
done

# Interrupted or no room, KILL, TERM, XCPU.
may_pass() { [[ $1 =~ ^(3|137|143|152)$ ]]; }
is_wanted() { [[ $(squeue --noheader --jobs="$task" --format=%T) == RUNNING ]]; }

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
trap : TERM # nobody is left to pass it on to

if may_pass "$status" && [[ ${SLURM_RESTART_COUNT:-0} -lt $most_restarts ]] && is_wanted; then
  echo "ended with $status; asks to be queued again"
  scontrol requeue "$task" && sleep infinity # until Slurm ends it
fi
exit "$status"
