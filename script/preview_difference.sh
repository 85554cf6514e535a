#!/bin/sh
# A table of how far the viewer's preview is from the traced image of the same view: mean FLIP, 0 equal to 1 opposite.
#
#     script/preview_difference.sh [-size N] [-keep folder] [-unshadowed] [scene ...]
#
# Scenes are by default twenty of the tree: lights, materials, textures, mirrors, glass, environments, many things. The
# preview is drawn without a window or words over it; the image has 16 samples per pixel, traced at the first run with
# -keep and then taken from there; -unshadowed presses Shift+L. RAYPRO, RAYIMG and RAYVIEW name the programs (default those
# of build/). When one of them fails, what it says is shown, and the table ends there.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
rayimg=${RAYIMG:-$here/build/rayimg}
rayview=${RAYVIEW:-$here/build/rayview}
size=256
samples=16
shadows=yes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
kept=$work
while [ $# -gt 0 ]; do
  case $1 in
    -size) size=$2; shift 2 ;;
    -unshadowed) shadows=no; shift ;;
    -keep) kept=$2; mkdir -p "$kept"; shift 2 ;;
    *) break ;;
  esac
done
if [ $# -eq 0 ]; then
  for name in scenes/hello scenes/texture scenes/bump scenes/materials scenes/specular scenes/emission scenes/coat \
              scenes/glass scenes/environment scenes/environment_probe scenes/spot_light scenes/area_light \
              scenes/sphere_light scenes/many_lights scenes/smooth art/cradle art/glass \
              writeup/scenes/still writeup/scenes/lamp; do
    set -- "$@" "$here/$name.scn"
  done
fi

# Words that are shown for a moment have gone by then.
{
  if [ "$shadows" = no ]; then echo 'key Shift+L'; fi
  echo 'tick 60'
} > "$work/events"
quietly() { "$@" > "$work/said" 2>&1 || { cat "$work/said" >&2; echo "preview_difference.sh: $1 failed" >&2; exit 1; }; }

printf '%-36s%10s\n' "scene, ${size}x${size}, $samples samples" FLIP
: > "$work/rows"
for scene in "$@"; do
  name=${scene#"$here"/}
  stem=$(printf '%s' "$name" | tr / _ | sed 's/\.[^.]*$//')
  traced=$kept/$stem.$size.traced.png
  drawn=$kept/$stem.$size.drawn.png
  [ -f "$traced" ] ||
    quietly "$raypro" "$scene" "$traced" -width "$size" -height "$size" -samples "$samples" -quiet -allow_path /
  quietly "$rayview" --headless "$scene" -width "$size" -height "$size" -allow_path / -events "$work/events" \
    -screenshot "$drawn"
  quietly "$rayimg" diff "$drawn" "$traced"
  flip=$(sed -n 's/^FLIP *//p' "$work/said")
  printf '%-36s%10.4f\n' "$name" "$flip" | tee -a "$work/rows"
done
awk '{ sum += $NF } END { printf "%-36s%10.4f\n", "mean of " NR, sum / NR }' "$work/rows"
