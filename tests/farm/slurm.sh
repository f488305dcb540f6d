#!/usr/bin/env bash
# samples/farm on a real Slurm of one node, which is started and stopped here and lives in FOLDER:
# tasks of an array that are killed are queued again, and the array ends with the pictures and recordings
# of one machine, byte for byte. Needs no rights; exit code 77 where Slurm is not installed.
#   slurm.sh BUILD FOLDER      BUILD: where the tools were built
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "$1")
rm -rf "$2" && mkdir -p "$2"
here=$(realpath "$2")
export PATH=$build/recorder:$build/player:/usr/sbin:$PATH
export SLURM_CONF=$here/slurm.conf
# Shorter names: a socket's has at most 107 characters.
sockets=$(mktemp -d)
processes=()

stop() {
  [[ ${#processes[@]} -eq 0 ]] || kill "${processes[@]}" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$sockets"
}
trap stop EXIT

fail() {
  echo "FAILED: $*"
  tail -n 5 "$here"/*.log
  exit 1
}

for program in slurmctld slurmd munged sbatch; do
  command -v "$program" >/dev/null || {
    echo "SKIPPED: $program is not installed (slurm-wlm)"
    exit 77
  }
done

# free_port FIRST: the first one at which nobody listens.
free_port() {
  local port=$1
  while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
  echo "$port"
}

# wait_until SECONDS COMMAND...
wait_until() {
  local end=$((SECONDS + $1))
  until "${@:2}"; do
    [[ $SECONDS -lt $end ]] || return 1
    sleep 0.2
  done
}

start_slurm() {
  mkdir -p "$here"/{state,spool}
  (umask 077 && head -c 1024 /dev/urandom >"$here/munge.key")
  cat >"$here/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=localhost
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$sockets/munge,cred_expire=5
SlurmctldPort=$(free_port 17817)
SlurmdPort=$(free_port 18818)
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SchedulerParameters=sched_interval=2
ReturnToService=2
NodeName=localhost CPUs=2 State=UNKNOWN
PartitionName=all Nodes=localhost Default=YES MaxTime=INFINITE State=UP
CONF
  munged --foreground --force --key-file="$here/munge.key" --socket="$sockets/munge" \
    --pid-file="$here/munged.pid" --log-file="$here/munged.log" --seed-file="$here/munge.seed" &
  processes+=($!)
  wait_until 10 test -S "$sockets/munge" || fail "munged does not start"
  slurmctld -D >"$here/slurmctld.log" 2>&1 &
  processes+=($!)
  slurmd -D -N localhost >"$here/slurmd.log" 2>&1 &
  processes+=($!)
  wait_until 60 node_is_idle || fail "the node does not come up"
}

node_is_idle() { [[ $(sinfo --noheader --format=%T 2>/dev/null) == idle ]]; }
is_over() { [[ -z $(squeue --noheader --jobs="$1" 2>/dev/null) ]]; }
# Of the command that tasks run, never of anybody else's.
tool_of_task() { pgrep --full --newest "^$1 .*$here" | head -n 1; }
runs() { [[ -n $(tool_of_task "$1") ]]; }

# kill_one TOOL: a task's tool dies as if the machine had run out of memory.
kill_one() {
  wait_until 60 runs "$1" || fail "no task runs $1"
  sleep 0.5
  kill -KILL "$(tool_of_task "$1")" || fail "$1 was too fast to be killed"
}

same() {
  diff --recursive --brief --exclude='*manifest.png*' "$1" "$2" || fail "$1 and $2 differ"
}

start_slurm
cd "$here"

echo "== Pictures of one recording, by four tasks"
ribbon-record "$root/samples/overhand-cylinder-8x400.toml" -o knot.rbn --until 2 --quiet
picture=(--isa avx2 --size 640x360)
grep --quiet avx2 /proc/cpuinfo || picture=(--isa sse2 --size 640x360)
ribbon-play knot.rbn -o 'one/{frame:04}.png' "${picture[@]}" --quiet
job=$("$root/samples/farm/pictures.sh" 4 "$here/knot.rbn" "$here/array/{frame:04}.png" "${picture[@]}")
kill_one ribbon-play
wait_until 300 is_over "$job" || fail "the array does not end"
grep --quiet "asks to be queued again" ribbon-"$job"_*.log || fail "nobody asked to be queued again"
same one array
[[ -z $(find array -name '*.part*') ]] || fail "something temporary is left"

echo "== A sweep of recordings"
cat >sweep.txt <<'SWEEP'
# a comment, and an empty line

slow fastening.speed=0.1 time.duration=3
fast fastening.speed=0.5 time.duration=3
SWEEP
mkdir alone
for line in "slow fastening.speed=0.1" "fast fastening.speed=0.5"; do
  read -r name setting <<<"$line"
  ribbon-record "$root/samples/overhand-cylinder-8x400.toml" --set "$setting" --set time.duration=3 \
    -o "alone/$name.rbn" --quiet
done
job=$("$root/samples/farm/sweep.sh" "$root/samples/overhand-cylinder-8x400.toml" "$here/sweep.txt" \
  "$here/sweep")
wait_until 60 runs ribbon-record || fail "no task records"
# As when the time is nearly up. It complains where one of the tasks is over by then.
scancel --batch --signal=TERM "$job" || true
wait_until 300 is_over "$job" || fail "the array does not end"
grep --quiet "asks to be queued again" ribbon-"$job"_*.log || fail "nobody asked to be queued again"
# A recording that was taken up again says so; its pictures are the same.
for name in slow fast; do
  for place in alone sweep; do
    ribbon-play "$place/$name.rbn" -o "frames-$place/$name.{frame:04}.png" --size 160x90 --samples 1 --quiet
  done
done
same frames-alone frames-sweep

echo "== A sweep that is cancelled stays so"
job=$("$root/samples/farm/sweep.sh" "$root/samples/overhand-cylinder-8x400.toml" "$here/sweep.txt" \
  "$here/cancelled")
wait_until 60 runs ribbon-record || fail "no task records"
scancel "$job"
wait_until 60 is_over "$job" || fail "what was cancelled is queued again"
! grep --quiet "asks to be queued again" ribbon-"$job"_*.log || fail "a cancelled task asked to be queued again"

echo "== A command that crashes is not queued again"
job=$(sbatch --parsable --array=1-2 "$root/samples/farm/task.sh" bash -c 'kill -SEGV $$')
wait_until 60 is_over "$job" || fail "what crashed is queued again"
! grep --quiet "asks to be queued again" ribbon-"$job"_*.log || fail "what crashed asked to be queued again"

echo "== Each line records what it says"
# refused WORD COMMAND...
refused() {
  local said
  said=$("${@:2}" 2>&1) && fail "'${*:2}' was not refused"
  [[ $said == *"$1"* ]] || fail "'${*:2}' says: $said"
}
sweep=("$root/samples/farm/sweep.sh" "$root/samples/overhand-cylinder-8x400.toml" "$here/wrong.txt" "$here/wrong")
for wrong in 'twice a=1\ntwice a=2\n:comes twice' 'cut a = 1\n:is no setting' 'cut a=[1, 2]\n:is no setting' \
  'dos a=1\r\n:as on Windows' '# nothing\n:no line with a name'; do
  printf '%b' "${wrong%:*}" >wrong.txt
  refused "${wrong##*:}" "${sweep[@]}"
done
record_line=("$root/samples/farm/record_line.sh" "$root/samples/overhand-cylinder-8x400.toml" "$here/lines.txt" lines)
printf 'plain\none fastening.speed=0.5 time.duration=0.1\nsilk cloth.fabric="silk" time.duration=0.04\n' >lines.txt
for line in 2 3 2 3; do # the second time there is nothing to add
  "${record_line[@]}" "$line" 2>>lines.log || fail "line $line was not recorded"
done
# Killed before its first checkpoint, at the end of its first frame or of nothing, it is begun anew.
whole=$(stat --format=%s lines/one.rbn)
for size in 0 20000 60000; do
  head --bytes="$size" lines/one.rbn >cut.rbn
  mv cut.rbn lines/one.rbn
  "${record_line[@]}" 2 2>>lines.log || fail "of $size bytes nothing was made"
  [[ $(stat --format=%s lines/one.rbn) -eq $whole ]] || fail "of $size bytes something else was made"
done
sed -i 's/speed=0.5/speed=0.6/' lines.txt
cp lines/one.rbn kept.rbn
refused "was recorded with 'fastening.speed=0.5 time.duration=0.1', not with" "${record_line[@]}" 2
cmp kept.rbn lines/one.rbn || fail "a recording with other settings was replaced"
echo "The array's pictures and recordings are those of one machine"
