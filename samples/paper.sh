#!/usr/bin/env bash
# Remakes what section 6 of the paper shows, by the published method and by the gate side by side: the scenes of
# Figures 16 to 19 as contact sheets from two views, what --verify finds in every frame of them, times, the same
# for stiffness from nothing to k/m = 1e6 (section 6.2), and the box tests of detection over ribbon sizes
# (section 5.4.3). Takes three to ten minutes. Results stay in out/paper; what is complete there is not made again.
#   samples/paper.sh [OPTION...]
#     --to FOLDER      results into this folder instead
#     --build FOLDER   use the tools and benchmarks built there instead of building
#     --quick          half a minute: coarse ribbons and the first half second, to see that all works (out/paper-quick)
#     --docs           put tables and pictures into docs/paper.md and docs/paper, too
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

# name, sample, what is set besides
figures=(
  '16-coarse overhand-hourglass-8x400'
  '19-coarse overhand-small-object-8x400'
  '17-coarse overhand-hourglass-8x400 ribbon.width=0.045'
  '16-fine overhand-hourglass-16x400'
  '18-fine overhand-cylinder-16x400'
  '19-fine overhand-small-object-16x400'
  '17-fine overhand-hourglass-16x400 ribbon.width=0.045'
)
stiffness=(0 1e2 1e4 1e5 1e6) # over a particle's mass, 1/s^2; the figures have 3.2e4
published=(contact=paper time.integrator=rk4 springs.damping=0)
methods=(gate published)

results='' tools='' quick='' docs=''
while [[ $# -gt 0 ]]; do
  case $1 in
    --quick) quick=yes ;;
    --docs) docs=yes ;;
    --to | --build)
      [[ $# -gt 1 ]] || { echo "$1 needs a folder" >&2; exit 2; }
      if [[ $1 == --to ]]; then results=$2; else tools=$2; fi
      shift
      ;;
    *)
      echo "unknown option '$1'; write --to FOLDER, --build FOLDER, --quick or --docs" >&2
      exit 2
      ;;
  esac
  shift
done
[[ -z $docs || -z $quick ]] || { echo "--docs shows what --quick does not measure; leave one out" >&2; exit 2; }
results=${results:-$root/out/paper${quick:+-quick}}

# A folder holds results of one kind only.
kind=${quick:+quick}
kind=${kind:-full}
mkdir -p "$results"
[[ -e $results/kind ]] || echo "$kind" >"$results/kind"
[[ $(<"$results/kind") == "$kind" ]] || {
  echo "$results holds results made $([[ $quick ]] && echo without || echo with) --quick; name another folder by --to" >&2
  exit 2
}

# settings_of METHOD SETTING...   Sets the array `settings` to the recorder's options. Of two settings of a key the later
# holds.
settings_of() {
  local setting all=()
  [[ -z $quick ]] || all+=(ribbon.along=100 ribbon.across=4)
  all+=("${@:2}" recording.max_position_error=0)
  [[ $1 == gate ]] || all+=("${published[@]}")
  [[ -z $quick ]] || all+=(time.duration=0.5)
  settings=()
  for setting in "${all[@]}"; do settings+=(--set "$setting"); done
}

# tied NAME METHOD SAMPLE SETTING...   Records, verifies and times it; the exit code 1 of --verify is an answer,
# too. What has a .verify is whole.
tied() {
  local run=$results/$1-$2 settings status=0
  [[ ! -e $run.verify ]] || return 0
  echo "== Tying $1, $2"
  settings_of "$2" "${@:4}"
  TIMEFORMAT='{"wall_s": %R, "user_s": %U, "system_s": %S}'
  { time "$tools/recorder/ribbon-record" "$root/samples/$3.toml" "${settings[@]}" --force -o "$run.rbn" \
    --quiet --stats "$run.stats" 2>&3; } 3>&2 2>"$run.time"
  "$tools/player/ribbon-play" "$run.rbn" --verify --json >"$run.verifying" || status=$?
  [[ $status -le 1 ]]
  mv "$run.verifying" "$run.verify"
}

# pictured NAME METHOD   As a contact sheet, and that small enough for a document.
pictured() {
  local run=$results/$1-$2
  [[ ! -e $run.small.png ]] || return 0
  echo "== Drawing $1, $2"
  "$tools/player/ribbon-play" "$run.rbn" --sheet "$run.png" --force --quiet
  ffmpeg -loglevel error -y -i "$run.png" -vf \
    'scale=960:-1:flags=area,split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none' "$run.new.png"
  mv "$run.new.png" "$run.small.png"
}

# Box tests, of the ribbon as it is drawn and of the gate's tight knot.
counted() {
  [[ ! -e $results/box_tests.json ]] || return 0
  echo "== Counting box tests"
  "$tools/tests/benchmarks/benchmark_box_tests" --tight "$results/16-coarse-gate.rbn" \
    --json "$results/box_tests.new" --most-particles "$([[ $quick ]] && echo 1200 || echo 12800)"
  mv "$results/box_tests.new" "$results/box_tests.json"
}

# By hands that do not yield: the softest cloth is at its limit of strain long before its loop has closed.
stiffened() {
  local ratio method newtons_per_metre
  for ratio in "${stiffness[@]}"; do
    newtons_per_metre=$(awk -v ratio="$ratio" 'BEGIN { print ratio / (4 * 200) }')
    for method in "${methods[@]}"; do
      tied "stiffness-$ratio" "$method" overhand-hourglass-8x400 ribbon.{across=4,along=200} \
        springs.{stretch,shear,bend}="$newtons_per_metre" fastening.yield=never time.duration=6
    done
  done
}

if [[ -z $tools ]]; then
  install_missing "${build_packages[@]}" "${test_packages[@]}"
  build release -DRIBBON_BUILD_TESTS=ON -DRIBBON_BUILD_BENCHMARKS=ON -- \
    ribbon-record ribbon-play benchmark_box_tests
  tools=$root/build/release
fi
for figure in "${figures[@]}"; do
  read -r name sample set <<<"$figure"
  for method in "${methods[@]}"; do
    tied "$name" "$method" "$sample" ${set:+"$set"}
    pictured "$name" "$method"
  done
  [[ $name != 16-coarse ]] || { counted; stiffened; }
done
python3 -B "$root/tests/benchmarks/plot_paper.py" "$results" ${docs:+"$root/docs/paper.md"}
