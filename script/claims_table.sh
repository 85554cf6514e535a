#!/bin/sh
# A table of what claimed errors are worth: scenes are rendered at 16, 32 and 64 samples per pixel with several seeds, and
# the error that each render claims is compared with the true one. Per scene and unit: renders, the median of claim/true,
# the shares of claims within .9-1.1 of the truth, below .8 and above 1.25 of it, how often the 95 % interval holds the
# truth, and the median of the degrees of freedom; below them all renders, and those of at least 270 degrees of freedom.
#
#     script/claims_table.sh [-seeds N] [-size N] [-references FOLDER] [-rows FILE] [-targets "E ..."]
#                            [-options "OPTIONS"] [id ...]
#
# With targets, each scene is rendered until its error is below each of them instead, with at most 2,048 samples. Per
# scene: renders that got there, the share of them whose true error is below the target, the largest true error in
# targets, and of those that took more than the least, 8 samples, the share whose true error is above 1/1.3 of it.
#
# -options are added to those of each render: with "-denoise" claims are those of denoised images. Ground truth comes from
# two references of 1024 samples of other seeds, kept in FOLDER (default build/claims) from run to run. With 6 seeds, the
# default, 20 scenes are 360 renders for displayed errors and 180 for linear ones: ten minutes of two cores, and as much
# for the references. -rows keeps one line per render. RAYPRO names the program (default build/raypro).
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
seeds=6 size=64 references=$here/build/claims rows= targets= more=
while [ $# -gt 0 ]; do
  case $1 in
    -seeds) seeds=$2 ;; -size) size=$2 ;; -references) references=$2 ;; -rows) rows=$2 ;; -targets) targets=$2 ;;
    -options) more=$2 ;;
    *) break ;;
  esac
  shift 2
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$references"

# id, scene, options.
cat > "$work/scenes" <<'LIST'
firefly bench/scenes/firefly -mode path -max_depth 4
bright bench/scenes/bright -mode path -max_depth 4
caustic bench/scenes/caustic -mode path -max_depth 6
indirect scenes/indirect -mode path
emissive scenes/emissive -mode path
hello scenes/hello
area_light scenes/area_light
lens scenes/lens -aperture .05 -focus 3
glossy scenes/glossy -glossy -mode path
many_lights scenes/many_lights -mode path
environment scenes/environment -mode path
sphere_light scenes/sphere_light -mode path
emission scenes/emission -mode path
depth scenes/depth -mode path
motion scenes/motion
camera_motion scenes/camera_motion
refraction scenes/refraction -mode path
materials scenes/materials -mode path
coat scenes/coat -mode path
glass scenes/glass -mode path
LIST

# A number of a report's "error".
value() { awk -v key="\"$1\":" '$1 == "\"error\":" { seen = 1 } seen && $1 == key { print $2 + 0; exit }' "$work/report"; }

run() {  # scene, options, further options
  # shellcheck disable=SC2086  # the options are words
  scene=$1 options=$2; shift 2
  "$raypro" "$here/$scene.scn" "$@" $options -width "$size" -height "$size" -quiet < /dev/null 2> "$work/messages" ||
    { cat "$work/messages" >&2; exit 1; }  # warnings of fireflies are what the table counts
}

# The rows of a scene and its options: claims at fixed samples, or what targets led to.
claims_of() {
  for samples in 16 32 64; do
    seed=1
    while [ "$seed" -le "$seeds" ]; do
      for unit in displayed linear; do
        suffix=
        if [ $unit = linear ]; then
          [ $((2 * seed)) -le "$seeds" ] || continue
          suffix=lin
        fi
        # An error that is never reached, so that all samples are taken and two streams made.
        run "$scene" "$options $more" "$work/picture.pfm" -samples "$samples" -seed "$seed" -error .000001$suffix \
          -adaptive off -reference "$both" -report "$work/report"
        echo "$unit $id $(value estimate) $(value low) $(value high) $(value true_error) $(value freedom)"
      done
      seed=$((seed + 1))
    done
  done
}
targets_of() {
  for target in $targets; do
    seed=1
    while [ "$seed" -le "$seeds" ]; do
      run "$scene" "$options $more" "$work/picture.pfm" -samples 2048 -seed "$seed" -error "$target" -reference "$both" \
        -report "$work/report"
      reason=$(awk '$1 == "\"reason\":" { gsub(/[",]/, "", $2); print $2; exit }' "$work/report")
      mean=$(awk '$1 == "\"mean\":" { print $2 + 0; exit }' "$work/report")
      echo "$id $target $(value true_error) $mean $reason"
      seed=$((seed + 1))
    done
  done
}

while read -r id scene options; do
  case " $* " in "  " | *" $id "*) ;; *) continue ;; esac
  both=$references/$id.$size.1.pfm,$references/$id.$size.2.pfm
  for which in 1 2; do
    reference=$references/$id.$size.$which.pfm
    [ -s "$reference" ] || run "$scene" "$options" "$reference" -samples 1024 -seed "900$which"
  done
  if [ "$targets" ]; then targets_of; else claims_of; fi
done < "$work/scenes" > "$work/rows"
[ -z "$rows" ] || cp "$work/rows" "$rows"

if [ "$targets" ]; then
  printf '%-16s%8s%8s%8s%8s%10s\n' scene renders kept largest longer '>= 1/1.3'
  awk '$5 == "error" { print "1" $1, $3 / $2, $4; print "2all", $3 / $2, $4 }' "$work/rows" | sort -k1,1 | awk '
    function line() {
      if (n) printf "%-16s%8d%8.3f%8.2f%8d%10s\n", substr(name, 2), n, kept / n, largest, longer, \
                    longer ? sprintf("%.2f", tight / longer) : "-"
      n = kept = largest = longer = tight = 0
    }
    $1 != name { line(); name = $1 }
    {
      ++n; kept += $2 <= 1
      if ($2 > largest) largest = $2
      if ($3 > 8) { ++longer; tight += $2 >= 1 / 1.3 }
    }
    END { line() }'
  exit
fi

printf '%-22s%8s%8s%8s%8s%8s%8s%8s\n' 'unit, scene' renders median .9-1.1 '<.8' '>1.25' '95 %' nu
# Each render counts for its scene, for all and for those of many degrees of freedom; ids sort these last.
awk '{ print $1, "1" $2, $0; print $1, "2all", $0; if ($7 >= 270) print $1, "3nu>=270", $0 }' "$work/rows" |
  sort -k1,1 -k2,2 | awk '
  function median(values, n,   i, k, least, swap) {
    for (i = 1; i < n; ++i) {
      least = i
      for (k = i + 1; k <= n; ++k) if (values[k] < values[least]) least = k
      swap = values[i]; values[i] = values[least]; values[least] = swap
    }
    return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
  }
  function line() {
    if (n) printf "%-22s%8d%8.2f%8.2f%8.3f%8.3f%8.3f%8.0f\n", name, n, median(ratio, n), close_ / n, low / n, high / n, \
                  held / n, median(freedom, n)
    n = close_ = low = high = held = 0
  }
  { next_name = $1 " " substr($2, 2) }
  next_name != name { line(); name = next_name }
  $8 > 0 {
    ++n; ratio[n] = $5 / $8; freedom[n] = $9
    close_ += ratio[n] >= .9 && ratio[n] <= 1.1; low += ratio[n] < .8; high += ratio[n] > 1.25
    held += $6 <= $8 && $8 <= $7
  }
  END { line() }'
