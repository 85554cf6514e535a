#!/bin/sh
# Renders the images of art/: generates the files that their scenes include, then art/NAME.jpg, 1920x1080 (the Cornell box
# 1080x1080).
# art/README.md has the seconds that each takes.
#
#     script/art.sh [-small] [name ...]
#
# Without names, all of them. -small writes a preview of 480x270 with a quarter of the samples to build/art instead.
# RAYPRO and RAYIMG name the programs. Each image records the command that made it: raypro -info art/glass.jpg.
set -eu
cd "$(dirname "$0")/.."
raypro=${RAYPRO:-build/raypro}
export RAYIMG="${RAYIMG:-$PWD/build/rayimg}"
small=
if [ "${1:-}" = -small ]; then small=yes; shift; fi
[ $# -gt 0 ] || set -- bearing chess cornell cradle glass library orrery valley

sh script/art/light.sh
for name in "$@"; do
  scene=art/$name.scn size="-width 1920 -height 1080" mode=path quality=88
  case $name in
    bearing) samples=24 options="-denoise -max_depth 6 -aperture 0.07 -focus 10.9" parts= ;;
    chess) samples=48 options="-denoise -max_depth 6 -aperture 0.06 -focus 10.5" parts="glass chess" ;;
    cornell) samples=512 options="-denoise -fresnel -max_depth 12" parts= size="-width 1080 -height 1080" ;;
    cradle) samples=64 options="-denoise -max_depth 6 -aperture 0.05 -focus 11.3 -clamp samples" parts="glass cradle" ;;
    glass) samples=96 options="-denoise -fresnel -max_depth 12 -aperture 0.12 -focus 10.2" parts=glass ;;
    library) samples=96 options="-denoise -max_depth 8" parts=library ;;
    orrery) samples=64 options="-max_depth 4 -clamp samples -error 2" parts=orrery ;;
    valley) samples=32 options="-max_depth 3" parts=valley ;;
    *) echo "unknown image '$name'; images are bearing, chess, cornell, cradle, glass, library, orrery, valley" >&2; exit 2 ;;
  esac
  for part in $parts; do sh "script/art/$part.sh"; done
  out=art/$name.jpg
  if [ "$small" ]; then
    mkdir -p build/art
    out=build/art/$name.jpg samples=$((samples / 4))
    case $name in cornell) size="-width 270 -height 270" ;; *) size="-width 480 -height 270" ;; esac
  fi
  # shellcheck disable=SC2086  # the options are words
  "$raypro" "$scene" "$out" $size -samples "$samples" -mode $mode -glossy $options -srgb -jpeg_quality $quality
done
