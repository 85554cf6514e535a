#!/bin/sh
# Builds raypro for another processor, runs it in an emulator, and compares its pictures with those of this machine's
# build/raypro, byte by byte: every scene in four ways, and the other settings on a few.
#
#     script/other_architecture.sh [-compiler C] [-emulator E] [-sysroot FOLDER] [-program P] [scene ...]
#
#   -compiler C       default aarch64-linux-gnu-g++; one that ends in g++ or clang++, beside its ar
#   -emulator E       what runs its programs, default qemu-aarch64; "" runs them as they are
#   -sysroot FOLDER   the other architecture's libraries as packages lay them out, usr/include and so on; default /
#   -program P        a raypro that is built already; nothing is built then
#   scene ...         default: all of scenes/
# RAYPRO names this machine's program (default build/raypro). On Debian without foreign packages installed, a sysroot is:
#     dpkg --add-architecture arm64; apt-get update; apt-get download libc6:arm64 libc6-dev:arm64 libjpeg62-turbo-dev:arm64 ...
#     for package in *.deb; do dpkg -x $package FOLDER; done
set -eu
export LC_ALL=C
cd "$(dirname "$0")/.."
here=${RAYPRO:-build/raypro} compiler=aarch64-linux-gnu-g++ emulator=qemu-aarch64 sysroot= program=
while [ $# -gt 0 ]; do
  case $1 in
    -compiler | -emulator | -sysroot | -program)
      [ $# -gt 1 ] || { echo "$1 takes a value" >&2; exit 2; }
      eval "${1#-}=\$2"
      shift 2 ;;
    -*) echo "unknown option $1; see the head of $0" >&2; exit 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- scenes/*.scn scenes/*.yaml scenes/*.yml scenes/*.json
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

if [ -z "$program" ]; then
  folder=build/$(basename "${compiler##* }")
  if [ -n "$sysroot" ]; then
    export PKG_CONFIG_SYSROOT_DIR="$sysroot"
    PKG_CONFIG_LIBDIR=$(find "$sysroot/usr" -type d -name pkgconfig | paste -sd :)
    export PKG_CONFIG_LIBDIR
  fi
  ar=${compiler##* }
  ar=${ar%g++}
  ar=${ar%clang++}ar
  make -s BUILD="$folder" CONTEXTS= AR="$ar" CXX="$compiler${sysroot:+ --sysroot=$sysroot}" raypro
  program=$folder/raypro
fi
# The loader is called by name: with a prefix for all files, emulators would look for scenes there as well.
libraries= loader=
if [ -n "$sysroot" ]; then
  loader=$(find "$sysroot/lib" "$sysroot/lib64" -maxdepth 1 -name 'ld-*.so*' 2> /dev/null | head -1)
  libraries=$(find "$sysroot/lib" "$sysroot/usr/lib" -name 'lib*.so*' -exec dirname {} + 2> /dev/null | sort -u | paste -sd :)
fi

there() {
  if [ -n "$loader" ]; then $emulator "$loader" --library-path "$libraries" "$program" "$@"; else $emulator "$program" "$@"; fi
}

compared=0 differ=0
compare() {  # extension, scene, options
  extension=$1 scene=$2
  shift 2
  for side in here there; do
    case $side in here) run=$here ;; there) run=there ;; esac
    $run "$scene" "$work/$side.$extension" -width 64 -height 48 -quiet "$@" > /dev/null 2> "$work/$side.txt" || {
      echo "failed ($side): $scene $*"
      head -3 "$work/$side.txt"
      differ=$((differ + 1))
      return 0
    }
  done
  compared=$((compared + 1))
  cmp -s "$work/here.$extension" "$work/there.$extension" || {
    differ=$((differ + 1))
    echo "differ: $scene $*"
  }
}

for scene; do
  case $scene in
    *.scn) ;;
    *) compare pfm "$scene"; continue ;;  # of courses, with settings of their own
  esac
  compare pfm "$scene" -samples 2 -shadow_samples 2
  compare pfm "$scene" -samples 4 -mode path
  compare pfm "$scene" -samples 2 -glossy -fresnel -max_depth 5 -roulette on -shadow_samples 2 -filter mitchell
  compare ppm "$scene" -samples 4 -mode path -glossy -fresnel -lights all -aperture .05 -focus 3 -motion .1 .05 0 -srgb
done
scenes="scenes/hello.scn scenes/area_light.scn scenes/glass.scn"
for scene in $scenes; do
  for filter in gaussian lanczos; do compare pfm "$scene" -samples 4 -filter $filter; done
  for sampler in random stratified grid; do compare pfm "$scene" -samples 4 -sampler $sampler -aperture .05 -focus 3; done
  for strategy in light bsdf uniform; do compare pfm "$scene" -samples 4 -mode path -strategy $strategy; done
  for mode in heat rays depth normal uv albedo id flat normal_color uv_color zbuffer gooch toon; do
    compare pfm "$scene" -samples 2 -mode $mode
  done
  for accelerator in none graph grid octree bvh; do compare pfm "$scene" -accel $accelerator; done
  compare pfm "$scene" -error 8 -samples 64
  compare pfm "$scene" -error 8 -samples 64 -mode path -adaptive tile
  compare pfm "$scene" -samples 8 -mode path -denoise
  compare ppm "$scene" -samples 2 -srgb -clamp samples -bytes truncated
done
echo "$compared pictures of $# scenes compared, $differ differ"
[ $differ = 0 ]
