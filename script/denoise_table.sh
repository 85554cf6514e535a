#!/bin/sh
# A table of what -denoise does: of scenes of scenes/ at 16 samples per pixel the displayed RMSE in 255ths, unfiltered and
# filtered, their ratio, the claim that the filtered picture comes with over the truth, and the processor seconds of both runs.
#
#     script/denoise_table.sh [-size N] [-samples N] [-seed N] [-filter name] [-denoiser name] [-references FOLDER]
#                             [-pictures FOLDER] [id ...]
#
# Ground truth comes from two references of other seeds, of 2048 and of 512 samples, kept in FOLDER (default build/denoise)
# from run to run: beside one alone its own noise would count as error, up to a quarter of what denoising leaves. Those of
# all scenes take some fifteen minutes at the default size, 192. With -pictures both pictures of each scene are kept there.
# -denoiser is that of raypro. RAYPRO names the program (default build/raypro).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
size=192 samples=16 seed=1 filter=box denoiser=regression references=$here/build/denoise pictures=
while [ $# -gt 0 ]; do
  case $1 in
    -size) size=$2 ;; -samples) samples=$2 ;; -seed) seed=$2 ;; -filter) filter=$2 ;; -denoiser) denoiser=$2 ;;
    -references) references=$2 ;; -pictures) pictures=$2 ;;
    *) break ;;
  esac
  shift 2
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ "$samples" -ge 2 ] || { echo "denoise_table.sh: -samples must be at least 2, got $samples" >&2; exit 2; }
mkdir -p "$references" ${pictures:+"$pictures"}

# id, scene, options: what the scene needs to show what it is about, and one shadow ray per light and sample.
cat > "$work/scenes" <<'LIST'
lens lens -aperture .12 -focus 5
area_light area_light -shadow_samples 1
depth depth -max_depth 8
glossy glossy -glossy
glossy_path glossy -glossy -mode path
motion motion
many_lights many_lights -lights one
indirect indirect -mode path -max_depth 4
emissive emissive -mode path
hello hello -shadow_samples 1
hello_path hello -mode path
glass glass -fresnel -max_depth 8
environment environment -mode path -glossy
sphere_light sphere_light -shadow_samples 1
refraction refraction
LIST

# A number of a report: value "key" FILE, the first below "from".
value() { awk -v from="\"$1\":" -v key="\"$2\":" '$1 == from { seen = 1 } seen && $1 == key { print $2 + 0; exit }' "$3"; }

printf '%-14s%10s%10s%8s%12s%9s%9s\n' id noisy denoised ratio claim/true cpu_s cpu_s
while read -r id scene options; do
  case " $* " in "  " | *" $id "*) ;; *) continue ;; esac
  reference=$references/$id.$size.$filter
  # shellcheck disable=SC2086
  set -- "$@" && run() { "$raypro" "$here/scenes/$scene.scn" "$@" $options -width "$size" -height "$size" -filter "$filter" -quiet; }
  [ -s "$reference.1.pfm" ] || run "$reference.1.pfm" -samples 2048 -seed 4711
  [ -s "$reference.2.pfm" ] || run "$reference.2.pfm" -samples 512 -seed 4712
  for name in noisy denoised; do
    streams="-denoise -denoiser $denoiser"
    # An error that is never reached makes two streams, as -denoise does.
    [ $name = denoised ] || streams="-error .000001 -adaptive off"
    # shellcheck disable=SC2086
    run "$work/$name.png" -samples "$samples" -seed "$seed" -reference "$reference.1.pfm,$reference.2.pfm" -report "$work/$name" $streams
    [ -z "$pictures" ] || cp "$work/$name.png" "$pictures/$id.$name.png"
  done
  echo "$id $(value error true_error "$work/noisy") $(value error true_error "$work/denoised") \
$(value error estimate "$work/denoised") $(value seconds cpu "$work/noisy") $(value seconds cpu "$work/denoised")"
done < "$work/scenes" | awk '
  { ratio = $3 / $2; claim = $4 / $3; logs += log(ratio); halved += ratio <= .5; worse += ratio > 1
    good += claim >= .8 && claim <= 1.2; before += $5; after += $6
    printf "%-14s%10.2f%10.2f%8.2f%12.2f%9.2f%9.2f\n", $1, $2, $3, ratio, claim, $5, $6 }
  END { printf "%d scenes: ratio %.2f in geometric mean, %d at most .5, %d above 1; %d claims within 20 %%; %.1f and %.1f s\n",
               NR, exp(logs / NR), halved, worse, good, before, after }'
