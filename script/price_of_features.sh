#!/bin/sh
# What features cost scenes that do not use them: for each feature the program is built once more from sources that its
# patch, script/price/FEATURE.patch, takes it out of, and both render scenes without it. Prints how many more instructions
# (valgrind) and CPU seconds (interleaved; the median of the ratios) the whole program takes, and whether the pictures are
# the same bytes. The aim: 0.5 % of instructions, 1 % of time, the same bytes.
#
#     script/price_of_features.sh [-repeats n] [-no_instructions] [feature ...]
#
#   -repeats n   how often each is timed (default 21)
#   feature      lens, motion ...; all of them unless some are given. A patched program takes any scene for one without
#                the feature. script/check_patches.sh says whether the patches still apply
#
# Exit status 1: a picture differs, or an aim is missed. The table goes to build/price/features.csv as well (OUT names
# another folder). BUILD names the build to start from (default build).
set -eu
export LC_ALL=C  # numbers have a point
cd "$(dirname "$0")/.."
build=${BUILD:-build}
out=${OUT:-$build/price}
repeats=21
instructions=yes
while [ $# -gt 0 ]; do
  case $1 in
    -repeats) repeats=$2; shift ;;
    -no_instructions) instructions=no ;;
    -*) echo "price_of_features.sh: unknown option $1; see the top of the script" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
known="lens motion environment textures vertex_colors bump absorption fresnel glossy roulette choice_of_lights wide_filter"
[ $# -gt 0 ] || set -- $known  # words
for feature; do
  echo "$known" | tr ' ' '\n' | grep -qx "$feature" || { echo "price_of_features.sh: no feature '$feature'; there are" $known >&2; exit 2; }
done
if [ $instructions = yes ] && ! command -v valgrind > /dev/null; then
  echo "no valgrind here, so no instructions are counted"
  instructions=no
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
mkdir -p "$out"

make -s BUILD="$build" raypro > /dev/null
whole=$build/raypro

# The sources and what was built of them once more; only what the patch touches is compiled again.
build_without() {  # feature
  tree=$work/$1
  mkdir -p "$tree/build/obj"
  mkdir -p "$tree/script"
  cp -rp Makefile R1 R2 R3 source "$tree"
  cp -p script/features.mk "$tree/script"
  cp -rp "$build/flags" "$build/features" "$tree/build"
  cp -rp "$build/obj/R1" "$build/obj/R2" "$build/obj/R3" "$build/obj/source" "$tree/build/obj"
  patch -s -d "$tree" -p1 < "script/price/$1.patch"
  make -s -C "$tree" BUILD=build raypro > /dev/null
}

render() {  # program, picture, options of the scene
  program=$1 picture=$2
  shift 2
  "$program" "$@" "$picture" -width 64 -height 64 -samples 16 -shadow_samples 1 -threads 1 -simd avx2 -quiet
}

# Those of rendering blocks alone, which repeat exactly; starting threads and reading files do not.
count() {  # program, options of the scene: instructions
  program=$1
  shift
  valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='ray::RenderBlock(*' "$program" \
    "$@" "$work/counted.pfm" -width 64 -height 64 -samples 4 -shadow_samples 1 -threads 1 -simd avx2 -quiet 2>&1 |
    sed -n 's/.*Collected *: *\([0-9]*\).*/\1/p'
}

seconds() {  # program, options of the scene: CPU seconds of one render
  program=$1
  shift
  render "$program" "$work/timed.pfm" "$@" -report "$work/report.json"
  sed -n 's/^ *"cpu": *\([0-9.e+-]*\).*/\1/p' "$work/report.json"
}

# Scenes without any of the features, name and options: the course's way and path tracing.
cat > "$work/scenes" <<'END'
whitted scenes/depth.scn -max_depth 6
path scenes/indirect.scn -mode path
END
csv=$out/features.csv
echo "feature,scene,instructions,instructions_without,instructions_percent,time_percent,time_low,time_high,same_bytes" > "$csv"
printf '%-18s%-9s%16s%14s%12s%22s  %s\n' feature scene instructions "a sample" "% more" "% more time (10-90)" bytes
missed=0
while read -r name options; do
  [ $instructions = no ] || count "$whole" $options > "$work/whole.$name" < /dev/null
done < "$work/scenes"
for feature; do
  build_without "$feature"
  without=$work/$feature/build/raypro
  while read -r name options; do
    # shellcheck disable=SC2086
    {
      render "$whole" "$work/a.pfm" $options
      render "$without" "$work/b.pfm" $options
      same=no
      cmp -s "$work/a.pfm" "$work/b.pfm" && same=yes
      a= b=
      if [ $instructions = yes ]; then
        a=$(cat "$work/whole.$name")
        b=$(count "$without" $options)
      fi
      : > "$work/ratios"
      i=0
      while [ "$i" -lt "$repeats" ]; do
        # Either goes first as often as the other, so that none always runs on a warmer machine.
        if [ $((i % 2)) = 0 ]; then
          t=$(seconds "$whole" $options) u=$(seconds "$without" $options)
        else
          u=$(seconds "$without" $options) t=$(seconds "$whole" $options)
        fi
        awk -v t="$t" -v u="$u" 'BEGIN { print 100 * (t / u - 1) }' >> "$work/ratios"
        i=$((i + 1))
      done
    } < /dev/null
    sort -g "$work/ratios" | awk -v feature="$feature" -v name="$name" -v a="$a" -v b="$b" -v same="$same" -v csv="$csv" '
      { r[NR] = $1 }
      function at(share) { return r[1 + int(share * (NR - 1) + 0.5)] }
      END {
        more = a ? 100 * (a / b - 1) : ""
        printf "%-18s%-9s%16s%14s%12s%8.2f (%.1f..%.1f)  %s\n", feature, name, a, a ? int(a / (64 * 64 * 4)) : "", \
          a ? sprintf("%.3f", more) : "", at(0.5), at(0.1), at(0.9), same == "yes" ? "same" : "DIFFERENT"
        printf "%s,%s,%s,%s,%s,%s,%s,%s,%s\n", feature, name, a, b, more, at(0.5), at(0.1), at(0.9), same >> csv
        exit same != "yes" || (a && more > 0.5) || at(0.5) > 1
      }' || missed=1
  done < "$work/scenes"
done
echo "rows are in $csv"
exit $missed
