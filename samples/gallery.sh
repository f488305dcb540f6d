#!/usr/bin/env bash
# Ties every knot of samples/gallery, verifies every frame, takes a picture of each and writes
# docs/gallery.md with what was measured: some minutes. Recordings stay in out/gallery.
#   samples/gallery.sh [OPTION...] [KNOT...]     without knots: all of them
#     --mirrored       each with the other hand as well: its mirror image
#     --build FOLDER   use the tools built there instead of building
#     --page           ties nothing: takes the pictures and writes the page of what was tied before
# Exit code 1 when a knot is not what was promised.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../.ci/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../.ci/setup.sh"

scenes=$root/samples/gallery
results=$root/out/gallery
pictures=$root/docs/gallery
finely=(--set recording.frames_per_second=50 --set recording.max_position_error=1e-6)
hands=(drawn)
tools=''
only_page=''
knots=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --mirrored) hands=(drawn mirrored) ;;
    --page) only_page=yes ;;
    --build)
      [[ $# -gt 1 ]] || { echo "$1 needs a folder" >&2; exit 2; }
      tools=$2
      shift
      ;;
    *)
      [[ -e $scenes/$1.toml ]] || { echo "there is no $scenes/$1.toml" >&2; exit 2; }
      knots+=("$1")
      ;;
  esac
  shift
done
if [[ ${#knots[@]} -eq 0 ]]; then
  for scene in "$scenes"/*.toml; do knots+=("$(basename "$scene" .toml)"); done
fi

# Where from its picture is taken, unless close to the knot.
declare -A view=(
  [bow]="azimuth=10,elevation=10,distance=2.2,lens=50,subject=knot"
  [figure-eight]="azimuth=140,elevation=25,subject=knot"
  [four-in-hand]="azimuth=0,elevation=6,distance=0.8,lens=50,subject=knot"
  [obi]="azimuth=0,elevation=12,distance=2,subject=knot"
  [stevedore]="azimuth=205,elevation=25,subject=knot"
)
# Likewise, with the point that is looked at, where tails that meet far from the knot would pass for it.
declare -A keyframe=([windsor]="0,0,8,0.9,50,0.13,-0.03,0.15")

# mirrored SCENE   Sets the array `settings` to what makes the scene its mirror image, reflected along the
# axis of the drawing, which is y in all of them: over and under, front and back, up and down.
mirrored() {
  local list reflected
  list=$(sed --quiet 's/^crossings = "\(.*\)".*/\1/p' "$1")
  if [[ -n $list ]]; then
    settings=(--set "curve.crossings=\"$(tr OUFB UOBF <<<"$list")\"")
  else
    settings=(--set 'curve.first="under"')
  fi
  while read -r reflected; do settings+=(--set "$reflected"); done < <(awk -F '[][,= ]+' '
    /^\[\[stage\]\]/ { stage++; hand = 0 }
    /^\[\[stage\.hand\]\]/ { hand++ }
    /^pull = \[/ { printf "stage[%d].hand[%d].pull=[%s, %s, %s]\n", stage, hand, $2, -$3, $4 }
    /^height = \[/ {
      printf "stage[%d].hand[%d].height=[", stage, hand
      for (i = 2; i < NF; i += 2) printf "%s[%s, %s]", (i > 2 ? ", " : ""), $i, -$(i + 1)
      print "]"
    }
    /^gravity = \[/ { printf "stage[%d].gravity=[%s, %s, %s]\n", stage, $2, -$3, $4 }
    /^acceleration = \[/ { printf "gravity.acceleration=[%s, %s, %s]\n", $2, -$3, $4 }
    /^position = \[/ { printf "obstacle.position=[%s, %s, %s]\n", $2, -$3, $4 }' "$1")
}

# tied NAME HAND   Records, verifies and times it; the exit code 1 of --verify is an answer, too. What has a
# .verify is whole. Recorded finely enough to see how calmly the knot rests in its last two seconds.
tied() {
  local run=$results/$1-$2 settings=() status=0
  [[ $2 == drawn ]] || mirrored "$scenes/$1.toml"
  echo "== Tying $1, $2"
  rm -f "$run.verify"
  TIMEFORMAT='{"wall_s": %R, "user_s": %U, "system_s": %S}'
  { time "$tools/recorder/ribbon-record" "$scenes/$1.toml" "${settings[@]}" "${finely[@]}" --force \
    -o "$run.rbn" --quiet --stats "$run.stats" 2>&3; } 3>&2 2>"$run.time"
  "$tools/player/ribbon-play" "$run.rbn" --verify --json >"$run.verifying" || status=$?
  [[ $status -le 1 ]]
  "$tools/converter/ribbon-convert" "$run.rbn" -o "$run.npy" --frames -101: --force --quiet
  mv "$run.verifying" "$run.verify"
}

pictured() {
  local camera=(--view "${view[$1]-knot}")
  if [[ -v keyframe[$1] ]]; then
    printf 'time,azimuth,elevation,distance,lens,x,y,z\n%s\n' "${keyframe[$1]}" >"$results/$1-camera.csv"
    camera=(--camera-path "$results/$1-camera.csv")
  fi
  "$tools/player/ribbon-play" "$results/$1-drawn.rbn" -o "$pictures/$1.png" --frames -1 --size 360x270 \
    "${camera[@]}" --force --quiet
}

if [[ -z $tools ]]; then
  install_missing "${build_packages[@]}" python3 python3-numpy
  build release -DRIBBON_BUILD_TESTS=OFF -- ribbon-record ribbon-play ribbon-convert
  tools=$root/build/release
fi
mkdir -p "$results" "$pictures"
for knot in "${knots[@]}"; do
  if [[ -z $only_page ]]; then
    for hand in "${hands[@]}"; do tied "$knot" "$hand"; done
  fi
  [[ ! -e $results/$knot-drawn.verify ]] || pictured "$knot"
done
PYTHONPATH=$root/tests/benchmarks python3 -B "$root/samples/gallery_page.py" "$scenes" "$results" "$root/docs/gallery.md"
