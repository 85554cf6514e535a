#!/bin/sh
# A table of what an accuracy costs: processor seconds, from the start of the program to the file, until the true error of a
# path-traced image is 4, 2, 1 and .5 of 255, as displayed. Columns: -error E and -error E -denoise, which know only what
# they measure; and an oracle's -samples N, plain and with -denoise: of renders with 2, 4, 8, ... samples per pixel, seconds
# and true errors are interpolated at E by their logarithms. Then the error that -error E -denoise leaves, and its seconds
# over those of the oracle's -denoise. Last the same oracle's for Mitsuba, plain and with Open Image Denoise, by
# script/mitsuba_times.py where its packages are installed. A dash: more than -seconds, 10 by default, or not installed.
#
#     script/time_to_error.sh [-size N] [-seeds N] [-seconds S] [-denoiser NAME] [-simd avx2] [-references FOLDER] [id ...]
#
# Ground truth comes from two references of 4,096 samples of other seeds, kept in FOLDER (default build/time_to_error) from
# run to run; those of all scenes take some ten minutes of two cores at the default size, 128, and Mitsuba's as long again.
# One seed by default; with more, seconds are means and errors roots of mean squares. RAYPRO names the program (default
# build/raypro), PYTHON the interpreter that has Mitsuba (default python3).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
python=${PYTHON:-python3}
size=128 seeds=1 seconds=10 denoiser=regression references=$here/build/time_to_error simd=best
while [ $# -gt 0 ]; do
  case $1 in
    -size) size=$2 ;; -seeds) seeds=$2 ;; -seconds) seconds=$2 ;; -denoiser) denoiser=$2 ;; -references) references=$2 ;;
    -simd) simd=$2 ;;
    *) break ;;
  esac
  shift 2
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$references"
targets="4 2 1 .5"

# id, scene, options.
cat > "$work/scenes" <<'LIST'
scan scan -max_depth 6
room room -max_depth 6
balls balls -max_depth 6
direct room -max_depth 0
lens balls -max_depth 6 -aperture .1 -focus 8.4
glass glass -max_depth 6
door door -max_depth 6
LIST

run() {  # image, further options
  # shellcheck disable=SC2086  # the options are words
  "$raypro" "$here/bench/scenes/$scene.scn" "$@" -mode path $options -width "$size" -height "$size" -simd "$simd" -quiet \
    < /dev/null 2> "$work/messages" || { cat "$work/messages" >&2; exit 1; }
}

# Processor seconds and the true error, over the seeds.
measure() {
  seed=1
  while [ "$seed" -le "$seeds" ]; do
    run "$work/image.pfm" "$@" -seed "$seed" -threads 1 -reference "$both" -report "$work/report"
    awk '$1 == "\"true_error\":" { error = $2 + 0 } $1 == "\"cpu\":" { cpu = $2 + 0 } END { print cpu, error }' \
      "$work/report"
    seed=$((seed + 1))
  done | awk '{ cpu += $1; square += $2 * $2 } END { print cpu / NR, sqrt(square / NR) }'
}

# The oracle's rows: seconds and true error of ever more samples, until the least target is reached or time is up.
curve() {
  samples=2
  while :; do
    row=$(measure -samples "$samples" "$@")
    echo "$row"
    echo "$row" | awk -v most="$seconds" '{ exit $1 > most || $2 < .5 }' || return 0
    samples=$((2 * samples))
  done
}
mitsuba() {  # further options: the oracle's rows, none without its packages
  if [ "$simd" = avx2 ]; then set -- "$@" -avx2; fi
  # shellcheck disable=SC2086  # the options are words
  "$python" "$here/script/mitsuba_times.py" "$here/bench/scenes/$scene.scn" -size "$size" -seconds "$seconds" $options \
    -references "$references/mitsuba_$id.$size" "$@" < /dev/null 2> "$work/messages" || cat "$work/messages" >&2
}
at() {  # file of a curve, target: the seconds at which it is crossed
  awk -v target="$2" '
    NR == 1 && $2 <= target { print $1; found = 1; exit }
    NR > 1 && last > target && $2 <= target {
      share = (log(last) - log(target)) / (log(last) - log($2))
      print exp(log(before) + share * (log($1) - log(before))); found = 1; exit
    }
    { before = $1; last = $2 }
    END { if (!found) print "-" }' "$1"
}
to_error() {  # the oracle's seconds, without which it is not tried: seconds to the target, and the true error there
  oracle=$1; shift
  if [ "$oracle" = - ]; then echo - -; else measure -error "$target" "$@"; fi
}

has() { "$python" -c "import $1" 2> /dev/null; }
format='%-8s%8s%10s%18s%10s%14s%12s%8s%10s%8s\n'
# shellcheck disable=SC2059  # the format is above
printf "$format" scene error -error '-error -denoise' oracle 'its -denoise' 'error left' ratio Mitsuba +OIDN
while read -r id scene options; do
  case " $* " in "  " | *" $id "*) ;; *) continue ;; esac
  both=$references/$id.$size.1.pfm,$references/$id.$size.2.pfm
  for which in 1 2; do
    reference=$references/$id.$size.$which.pfm
    [ -s "$reference" ] || run "$reference" -samples 4096 -seed "900$which"
  done
  curve > "$work/plain"
  curve -denoise -denoiser "$denoiser" > "$work/denoised"
  : > "$work/mitsuba"
  : > "$work/mitsuba_denoised"
  if has mitsuba; then
    mitsuba > "$work/mitsuba"
    if has pyoidn; then mitsuba -denoise > "$work/mitsuba_denoised"; fi
  fi
  for target in $targets; do
    plain=$(at "$work/plain" "$target") denoised=$(at "$work/denoised" "$target")
    [ "$plain$denoised" != "--" ] || continue
    echo "$id $target $(to_error "$plain") $(to_error "$denoised" -denoise -denoiser "$denoiser") $plain $denoised" \
      "$(at "$work/mitsuba" "$target") $(at "$work/mitsuba_denoised" "$target")"
  done
done < "$work/scenes" | awk -v format="$format" '
  function seconds(x) { return x == "-" ? x : sprintf("%.2f", x) }
  { ratio = $5 == "-" || $8 == "-" ? "-" : sprintf("%.2f", $5 / $8)
    printf format, $1, $2, seconds($3), seconds($5), seconds($7), seconds($8), seconds($6), ratio, seconds($9), seconds($10)
    fflush() }'
