#!/bin/sh
# A table of seconds: every scene given (default: those of scenes/), rendered with every accelerator, from the start of the
# program to the finished file.
#
#     script/time_scenes.sh [-size N] [scene.scn ...]
#
# RAYPRO names the program (default build/raypro), RUNS how many runs each takes (default 3; the median is printed).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
runs=${RUNS:-3}
size=512
if [ "${1:-}" = -size ]; then size=$2; shift 2; fi
[ $# -gt 0 ] || set -- "$here"/scenes/*.scn
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
  printf '%-44s' "${scene#"$here"/}"
  for a in $accelerators; do printf '%10s' "$(seconds "$scene" "$a")"; done
  echo
done
