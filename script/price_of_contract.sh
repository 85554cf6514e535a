#!/bin/sh
# What the promise "boxes only cull, doubles decide" costs: the same bench with hits accepted in single precision
# (script/price/floats.patch), and with boxes that are not padded (script/price/unpadded.patch). Prints how many times
# as fast those are; their answers may be wrong and are ignored.
#
#     script/price_of_contract.sh [rabbit,head,... [packet=16 kind=primary,shadow]]
#
# Arguments after the scenes are passed to the bench; those above measure packets of 16 instead of single rays.
set -eu
export LC_ALL=C  # numbers have a point
cd "$(dirname "$0")/.."
scenes=${1:-rabbit,head,blob,soup,colonnade,city}
[ $# = 0 ] || shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The sources once more, beside the build, so that compiler caches know them; then patched and built.
build() {  # variant, its patch if any
  tree=build/price/$1
  rm -rf "$tree/source" "$tree/R1" "$tree/R2" "$tree/R3" "$tree/bench"  # a file that is gone must be gone here too
  mkdir -p "$tree"
  mkdir -p "$tree/script"
  cp -rp Makefile R1 R2 R3 source bench "$tree"
  cp -p script/features.mk "$tree/script"
  [ -z "${2:-}" ] || patch -s -d "$tree" -p1 < "$2"
  make -s -C "$tree" build/bench/kernels > /dev/null
}
build exact
build floats script/price/floats.patch
build unpadded script/price/unpadded.patch
for round in 1 2 3; do
  for variant in exact floats unpadded; do
    "build/price/$variant/build/bench/kernels" scene="$scenes" rays=250000 repeats=3 peer=0 "$@" 2> /dev/null |
      awk -v v=$variant '$3 == "bvh" && $2 ~ /primary|shadow|diffuse/ { print v, $1, $2, $4 }' >> "$work/$round"
  done
done
awk '
  { rate[$1, $2, $3, FILENAME] = $4; seen[$2 " " $3]; files[FILENAME] }
  END {
    for (key in seen) {
      split(key, k, " ")
      for (f in files) {
        e = rate["exact", k[1], k[2], f]
        floats += log(rate["floats", k[1], k[2], f] / e); unpadded += log(rate["unpadded", k[1], k[2], f] / e); n++
      }
    }
    printf "hits accepted in single precision: %.2f times as fast\nboxes not padded: %.2f times as fast\n", \
      exp(floats / n), exp(unpadded / n)
  }' "$work"/?
