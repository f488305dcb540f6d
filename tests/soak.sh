#!/usr/bin/env bash
# The long runs behind the figures: records scenes in full, verifies each recording by both oracles and
# prints one table. Takes hours; stopped and called again, it goes on where it was. Not part of run.sh.
#   tests/soak.sh [OPTION...] [PART...]      without parts: all of them
#     samples   every scene in samples/ and samples/gallery
#     jitter    10 starts of each 8x400 scene, of reef, bow and four-in-hand, the drawing moved by up to
#               4 mm, seeds 1 to 10
#     force     each 8x400 scene with ten times the fastening speed
#     cost      each 8x400 scene with the gate, without it and as published, alternating
#     kills     kills the recorder 500 times at random moments of a small run, and ten times of each
#               8x400 scene; after each, what is left is played and the run is resumed: to the same bits
#     table     only prints what is there
#   --results FOLDER     keep results there (default: a folder of its own for each commit in out/soak)
#   --duration SECONDS   cut the runs short, to try this script
#   --kills N            kill that often instead of 500 times
#   --build FOLDER       use the tools built there instead of building
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

seeds=10
kills=500
jitter_m=0.004
results=''
duration=''
tools=''
parts=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --results | --duration | --kills | --build)
      [[ $# -gt 1 ]] || { echo "$1 needs a value" >&2; exit 2; }
      case $1 in
        --results) results=$2 ;;
        --duration) duration=$2 ;;
        --kills) kills=$2 ;;
        --build) tools=$2 ;;
      esac
      shift 2
      ;;
    samples | jitter | force | cost | kills | table)
      parts+=("$1")
      shift
      ;;
    *)
      echo "'$1' is not understood; write samples, jitter, force, cost, kills or table" >&2
      exit 2
      ;;
  esac
done
[[ ${#parts[@]} -gt 0 ]] || parts=(samples jitter force cost kills)
: "${results:=$root/out/soak/$(git -C "$root" rev-parse --short HEAD)${duration:+-$duration-s}}"
scenes=$results/scenes

prepare() {
  install_missing "${build_packages[@]}" "${test_packages[@]}"
  if [[ -z $tools ]]; then
    build release -DRIBBON_BUILD_TESTS=ON -- ribbon-record ribbon-play record_without_contact \
      jittered_scene count_strained_springs verify_with_cgal kill_recorder
    tools=$root/build/release
  fi
  mkdir -p "$scenes"
  # Scenes name their drawing and their obstacle relative to themselves, those of the gallery also one
  # folder higher.
  cp "$root"/samples/{,gallery/}*.svg "$root"/samples/*.obj "$scenes"
  cp "$root"/samples/*.{svg,obj} "$results"
}

# scene NAME FROM SED_SCRIPT   Makes $scenes/NAME.toml once: a scene like FROM, edited.
scene() {
  [[ ! -e $scenes/$1.toml ]] || return 0
  sed --expression "1,/^\[/s/^name = .*/name = \"$1\"/" ${duration:+--expression "s/^duration = .*/duration = $duration/"} \
    --expression "$3" "$2" >"$scenes/$1.tmp"
  mv "$scenes/$1.tmp" "$scenes/$1.toml"
}

# finished FILE COMMAND...   Keeps the command's output as FILE when it succeeds; once is enough. The
# exit code 1 of what verifies is an answer, too.
finished() {
  local status=0
  [[ ! -e $1 ]] || return 0
  "${@:2}" >"$results/unfinished.txt" || status=$?
  if [[ $status -gt 1 ]]; then
    echo "failed: ${*:2}" >&2
    return 1
  fi
  mv "$results/unfinished.txt" "$1"
}

# recorded NAME RECORDER   Records $scenes/NAME.toml once. A scene that is refused stays in the table.
recorded() {
  local run=$results/$1 status=0
  [[ ! -e $run.rbn && ! -e $run.refused ]] || return 0
  echo "== Recording $1"
  "$2" "$scenes/$1.toml" --force -o "$results/unfinished.rbn" --quiet --stats "$results/unfinished.json" \
    2>"$results/unfinished.txt" || status=$?
  case $status in
    0)
      mv "$results/unfinished.json" "$run.stats"
      mv "$results/unfinished.rbn" "$run.rbn"
      ;;
    2)
      cat "$results/unfinished.txt" >&2
      mv "$results/unfinished.txt" "$run.refused"
      ;;
    *)
      echo "the recorder ended with $status" >&2
      return 1
      ;;
  esac
}

# verified NAME
verified() {
  local run=$results/$1
  [[ -e $run.rbn ]] || return 0
  echo "== Verifying $1"
  finished "$run.verify" "$tools/player/ribbon-play" "$run.rbn" --verify --json
  finished "$run.cgal" "$tools/tests/verification/verify_with_cgal" "$run.rbn"
  finished "$run.strain" "$tools/tests/soak/count_strained_springs" "$run.rbn"
}

# one PART NAME [RECORDER]   The part is noted for the table.
one() {
  echo "$1" >"$results/$2.part"
  recorded "$2" "${3:-$tools/recorder/ribbon-record}"
  verified "$2"
}

name_of() { basename "$1" .toml; }

samples() {
  local sample
  for sample in "$root"/samples/{,gallery/}*.toml; do
    scene "$(name_of "$sample")" "$sample" ''
    one samples "$(name_of "$sample")"
  done
}

jitter() {
  local sample seed name
  for seed in $(seq "$seeds"); do
    for sample in "$root"/samples/{*-8x400,gallery/{reef,bow,four-in-hand}}.toml; do
      name=$(name_of "$sample")-jitter-$seed
      if [[ ! -e $scenes/$name.toml ]]; then
        "$tools/tests/soak/jittered_scene" "$sample" "$seed" "$jitter_m" "$scenes/jittered.toml"
        scene "$name" "$scenes/jittered.toml" ''
        rm "$scenes/jittered.toml"
      fi
      one jitter "$name"
    done
  done
}

force() {
  local sample name speed
  for sample in "$root"/samples/*-8x400.toml; do
    name=$(name_of "$sample")-force-x10
    speed=$(sed --quiet 's/^speed = //p' "$sample")
    scene "$name" "$sample" "s/^speed = .*/speed = $(awk "BEGIN { print 10 * $speed }")/"
    one force "$name"
  done
}

# Whenever they are tight.
equally_long='/^until/d;s/^duration = 20.0/duration = 8.0/'

# Three methods in turn for each scene, so that whatever else the machine does meets all of them.
cost() {
  local sample name
  for sample in "$root"/samples/*-8x400.toml; do
    name=$(name_of "$sample")-cost
    scene "$name-gate" "$sample" "$equally_long"
    scene "$name-no-contact" "$sample" "$equally_long"
    scene "$name-paper" "$sample" "$equally_long;/^name/a contact = \"paper\""
    one cost "$name-gate"
    one cost "$name-no-contact" "$tools/tests/soak/record_without_contact"
    one cost "$name-paper"
  done
}

# killed SCENE TIMES   The seed is the number of kills, so that more of them are others.
killed() {
  local name
  name=$(name_of "$1")
  finished "$results/$name.kills" "$tools/tests/soak/kill_recorder" "$tools/recorder/ribbon-record" "$1" "$2" "$2"
  cat "$results/$name.kills"
  grep --quiet '"problem":""' "$results/$name.kills"
}

kills() {
  local sample name
  echo "== Killing the recorder $kills times"
  mkdir -p "$results/killed"
  cp "$root"/samples/*.svg "$root"/samples/*.obj "$results/killed"
  cp "$root/tests/soak/killed.toml" "$results/killed"
  killed "$results/killed/killed.toml" "$kills"
  for sample in "$root"/samples/*-8x400.toml; do
    name=$(name_of "$sample")
    sed --expression 's/^duration = .*/duration = 2.0/' "$sample" >"$results/killed/$name.toml"
    killed "$results/killed/$name.toml" 10
  done
}

# Without this, a recorder that Ctrl-C ends early would count as finished.
trap 'exit 130' INT TERM
mkdir -p "$results"
[[ ${parts[*]} == table ]] || prepare
for part in "${parts[@]}"; do
  [[ $part == table ]] || "$part"
done
python3 "$root/tests/soak/table.py" "$results"
