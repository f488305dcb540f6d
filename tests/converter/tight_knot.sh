#!/bin/sh
# Records a small tight knot, whose layers lie so close that another choice of diagonals intersects.
#   tight_knot.sh RIBBON_RECORD SCENE KNOT.rbn
exec "$1" "$2" -o "$3" --force --quiet --set ribbon.across=4 --set ribbon.along=200 \
  --set fastening.speed=0.5 --set time.duration=5 --set recording.frames_per_second=5
