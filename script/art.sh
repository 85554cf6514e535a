#!/bin/sh
# Renders the pictures of art/: generates the files that their scenes include, then art/NAME.jpg, 1920x1080 and denoised.
# art/README.md has the seconds that each takes.
#
#     script/art.sh [-small] [name ...]
#
# Without names, all of them. -small writes a preview of 480x270 with a quarter of the samples to build/art instead.
# RAYPRO and RAYIMG name the programs. Each picture records the command that made it: raypro -info art/glass.jpg.
set -eu
cd "$(dirname "$0")/.."
raypro=${RAYPRO:-build/raypro}
export RAYIMG="${RAYIMG:-$PWD/build/rayimg}"
small=
if [ "${1:-}" = -small ]; then small=yes; shift; fi
[ $# -gt 0 ] || set -- glass flake stairs cradle city sponge

sh script/art/light.sh
for name in "$@"; do
  case $name in
    glass) samples=96 options="-fresnel -max_depth 12 -aperture 0.12 -focus 10.2" parts=glass ;;
    flake) samples=24 options="-max_depth 6" parts=flake ;;
    stairs) samples=40 options="-max_depth 6" parts=stairs ;;
    cradle) samples=48 options="-max_depth 8 -aperture 0.06 -focus 11.5" parts="glass cradle" ;;
    city) samples=32 options="-max_depth 4" parts=city ;;
    sponge) samples=32 options="-max_depth 5" parts=sponge ;;
    *) echo "unknown picture '$name'; pictures are city, cradle, flake, glass, sponge and stairs" >&2; exit 2 ;;
  esac
  for part in $parts; do sh "script/art/$part.sh"; done
  out=art/$name.jpg size="-width 1920 -height 1080"
  if [ "$small" ]; then
    mkdir -p build/art
    out=build/art/$name.jpg size="-width 480 -height 270" samples=$((samples / 4))
  fi
  # shellcheck disable=SC2086  # the options are words
  "$raypro" "art/$name.scn" "$out" $size -samples "$samples" -denoise -mode path -glossy $options -srgb -jpeg_quality 88
done
