#!/bin/sh
# What every accelerator tests: boxes, nodes and primitives per ray, build and render seconds, bytes; `graph` also with each
# of its techniques off.
#
#     script/compare_accelerators.sh [scene.scn ...]        (default: some of scenes/)
#
# RAYPRO names the program (default build/raypro).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
[ $# -gt 0 ] || set -- "$here"/scenes/hello.scn "$here"/scenes/hierarchy.scn "$here"/scenes/smooth.scn
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

number() {  # name: its last value in the report
  sed -n "s/.*\"$1\": *\([0-9.e+-]*\).*/\1/p" "$work/report.json" | tail -1
}

row() {  # title, then options
  title=$1
  shift
  "$raypro" "$scene" "$work/out.png" -width 128 -height 128 -quiet -report "$work/report.json" -allow_path / "$@" 2> /dev/null ||
    { printf '  %-22s failed\n' "$title"; return; }
  # The counts of all rays come after those of each kind.
  rays=$(sed -n 's/.*"total": *\([0-9]*\).*/\1/p' "$work/report.json" | head -1)
  echo "$rays $(number node_visits) $(number box_tests) $(number primitive_tests) $(number build) $(number render) $(number structure_bytes)" |
    awk -v title="$title" '{ printf "  %-22s%9.1f%9.1f%12.1f%10.3f%10.3f%12d\n", title, $2 / $1, $3 / $1, $4 / $1, $5, $6, $7 }'
}

for scene; do
  echo "$(basename "$scene")"
  printf '  %-22s%9s%9s%12s%10s%10s%12s\n' "per ray:" nodes boxes primitives "build s" "render s" bytes
  for a in $("$raypro" -list accelerators | awk '/^  / { print $1 }'); do
    row "$a" -accel "$a"
    [ "$a" = graph ] || continue
    row "graph, no boxes" -accel graph -node_boxes off
    row "graph, unsorted" -accel graph -front_to_back off
    row "graph, no last hit" -accel graph -last_hit off
    row "graph, none of them" -accel graph -node_boxes off -front_to_back off -last_hit off
  done
done
