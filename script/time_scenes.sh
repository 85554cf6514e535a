#!/bin/sh
# A table of seconds: every scene given (default: those of scenes/, and the public course scenes where they lie beside the
# checkout), rendered with every accelerator, start of the program to finished file.
#
#     script/time_scenes.sh [-size N] [scene.scn ...]
#
# RAYPRO names the program (default build/raypro), RUNS how often each is run (default 3; the median is printed).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
runs=${RUNS:-3}
size=512
if [ "${1:-}" = -size ]; then size=$2; shift 2; fi
if [ $# -eq 0 ]; then
  set -- "$here"/scenes/*.scn
  for year in 2007-08 2011-12; do
    [ -d "$here/../shared/scenes-cos426/course-$year" ] && set -- "$@" "$here/../shared/scenes-cos426/course-$year"/*.scn
  done
  [ -d "$here/../shared/scenes-cos426/course-526" ] && set -- "$@" "$here"/../shared/scenes-cos426/course-526/*.scn
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Median wall seconds of $runs runs, from the program's own report.
seconds() {
  i=0
  : > "$work/times"
  while [ "$i" -lt "$runs" ]; do
    "$raypro" "$1" "$work/out.png" -width "$size" -height "$size" -accel "$2" -quiet -report "$work/report.json" \
      -allow_path / 2> /dev/null || { echo failed; return; }
    sed -n 's/.*"wall": *\([0-9.e+-]*\).*/\1/p' "$work/report.json" | tail -1 >> "$work/times"
    i=$((i + 1))
  done
  sort -n "$work/times" | sed -n "$(((runs + 1) / 2))p" | awk '{ printf "%.3f", $1 }'
}

accelerators=${ACCELERATORS:-$("$raypro" -list accelerators | awk '/^  / { print $1 }')}
printf '%-44s' "scene, ${size}x${size}, seconds"
for a in $accelerators; do printf '%10s' "$a"; done
echo
for scene in "$@"; do
  name=${scene#"$here"/}
  printf '%-44s' "${name#../shared/scenes-cos426/}"
  for a in $accelerators; do printf '%10s' "$(seconds "$scene" "$a")"; done
  echo
done
