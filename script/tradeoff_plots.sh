#!/bin/sh
# Summarizes what script/tradeoff.sh measured: prints which presets are dominated, and plots with gnuplot, beside the CSV,
# as SVG, and as PNG if gnuplot can.
#
#     script/tradeoff_plots.sh [tradeoff.csv [price_of_features.csv]]
#
#   samplers      RMSE over CPU seconds, one line per sampler; slopes are over the number of samples, from 4 up
#   pareto        every setting tried; gray ones are dominated in time and error by another; presets have names
#   claims        estimated over true error, one dot per render, and the fraction within 10 %
#   accelerators  seconds to build and to trace, one thread
#   features      the cost of features in scenes that do not use them, from script/price_of_features.sh
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
csv=${1:-$here/build/tradeoff/small/tradeoff.csv}
features=${2:-$here/build/price/features.csv}
out=$(dirname "$csv")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Sums the seeds of every setting up: scene, knob, value, cpu_s (median), rmse (root of the mean square), display (the
# same), samples, build_s and render_s (medians), primitives, rays.
awk -F, -v OFS='\t' '
  function median(list,   v, n, i, j, x) {
    n = split(list, v, " ")
    for (i = 2; i <= n; ++i) { x = v[i] + 0; for (j = i; j > 1 && v[j - 1] + 0 > x; --j) v[j] = v[j - 1]; v[j] = x }
    return n % 2 ? v[(n + 1) / 2] : (v[n / 2] + v[n / 2 + 1]) / 2
  }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  {
    key = $at["scene"] OFS $at["knob"] OFS $at["value"]
    if (!(key in n)) order[++count] = key
    ++n[key]
    cpu[key] = cpu[key] " " $at["cpu_s"]; build[key] = build[key] " " $at["build_s"]
    trace[key] = trace[key] " " $at["render_s"]
    e = $at["rmse"]; square[key] += e * (e < 0 ? -e : e)
    display[key] += $at["display"] ^ 2
    samples[key] += $at["samples"]; rays[key] += $at["rays"]; primitives[key] = $at["primitives"]
  }
  END {
    for (i = 1; i <= count; ++i) {
      k = order[i]
      m = square[k] / n[k]
      print k, median(cpu[k]), (m > 0 ? sqrt(m) : "nan"), sqrt(display[k] / n[k]), samples[k] / n[k], median(build[k]), \
        median(trace[k]), primitives[k], rays[k] / n[k]
    }
  }' "$csv" > "$work/settings.tsv"

# A preset is dominated in a scene by a setting that is better by more than 10 % in time and in error. Rays stand for
# time as well, because seconds of short renders on a busy machine vary by that much.
awk -F'\t' '
  $2 ~ /^(filter|accel|accel_res)$/ { next }
  { ++n; scene[n] = $1; knob[n] = $2; value[n] = $3; cpu[n] = $4; error[n] = $6; rays[n] = $11 }
  END {
    for (i = 1; i <= n; ++i) if (knob[i] == "quality") {
      if (!(value[i] in scenes)) order[++presets] = value[i]
      ++scenes[value[i]]
      by_cpu = by_rays = 0
      for (j = 1; j <= n; ++j) if (knob[j] != "quality" && scene[j] == scene[i] && 1.1 * error[j] < error[i]) {
        if (1.1 * cpu[j] < cpu[i]) by_cpu = 1
        if (1.1 * rays[j] < rays[i]) by_rays = 1
      }
      if (by_cpu) in_cpu[value[i]] = in_cpu[value[i]] " " scene[i]
      if (by_rays) in_rays[value[i]] = in_rays[value[i]] " " scene[i]
    }
    for (i = 1; i <= presets; ++i) {
      p = order[i]
      printf "preset %s is dominated in error and CPU seconds in %d of %d scenes%s%s, in error and rays in %d%s%s\n", p, \
        split(in_cpu[p], unused, " "), scenes[p], in_cpu[p] ? ":" : "", in_cpu[p], split(in_rays[p], unused, " "), \
        in_rays[p] ? ":" : "", in_rays[p]
    }
  }' "$work/settings.tsv"

if ! command -v gnuplot > /dev/null; then
  echo "gnuplot is not installed: no plots; the rows are in $csv"
  exit 0
fi
scenes=$(cut -f1 "$work/settings.tsv" | awk '!seen[$0]++')
count=$(echo "$scenes" | wc -l)
columns=$(awk -v n="$count" 'BEGIN { c = int(sqrt(n) + 0.999); print (n > 6 && c < 4 ? 4 : c) }')
rows=$(((count + columns - 1) / columns))
width=$((columns * 420))
height=$((rows * 360 + 60))

title() { echo "$1" | tr _ ' '; }

draw() {  # name, width, height; the commands come on standard input
  cat > "$work/$1.gp"
  {
    echo "set terminal svg size $2,$3 font 'Helvetica,13' background 'white'; set output '$out/$1.svg'"
    cat "$work/$1.gp"
  } | gnuplot
  echo "$out/$1.svg"
  gnuplot -e 'set terminal' 2>&1 | grep -q pngcairo || return 0
  {
    echo "set terminal pngcairo size $2,$3 font 'Helvetica,10' background 'white'; set output '$out/$1.png'"
    cat "$work/$1.gp"
  } | gnuplot
}

# 1: one block of data per scene and sampler, two empty lines between.
awk -F'\t' -v prefix="$work/sampler." '
  $2 == "samples" || $2 == "sampler" {
    name = $2 == "samples" ? "sobol" : $3
    sub(/ .*/, "", name)
    key = $1 "." name
    if ($5 != "nan") print $4, $5 > (prefix key)
    if ($7 < 4 || $5 == "nan") next
    x = log($7); y = log($5)
    ++n[key]; sx[key] += x; sy[key] += y; sxx[key] += x * x; sxy[key] += x * y
  }
  END {
    for (key in n) {
      below = n[key] * sxx[key] - sx[key] ^ 2
      slope = below > 0 ? sprintf("%.2f", (n[key] * sxy[key] - sx[key] * sy[key]) / below) : ""
      print key, slope > (prefix "slopes")
    }
  }' "$work/settings.tsv"
{
  echo "set multiplot layout $rows,$columns title 'Error over time, by sampler (slopes over samples)'"
  echo "set logscale xy; set grid; set format '%g'; set key bottom left samplen 1; set xlabel 'CPU seconds' offset 0,0.5"
  for scene in $scenes; do
    echo "set title '$(title "$scene")'; set ylabel 'linear RMSE' offset 1.5"
    lines=
    color=1
    for sampler in sobol stratified random; do
      [ -f "$work/sampler.$scene.$sampler" ] || continue
      slope=$(sed -n "s/^$scene\.$sampler //p" "$work/sampler.slopes")
      lines="$lines, '$work/sampler.$scene.$sampler' with linespoints pt 7 ps .5 lw 2 lc $color title '$sampler $slope'"
      color=$((color + 1))
    done
    [ -n "$lines" ] && echo "plot ${lines#, }"
  done
  echo "unset multiplot"
} | draw samplers "$width" "$height"

# 2: filters converge to other pictures and accelerators to the same one, so neither is part of the trade-off.
sort -t'	' -k1,1 -k4,4g -k6,6g "$work/settings.tsv" | awk -F'\t' -v prefix="$work/pareto." '
  $2 ~ /^(filter|accel|accel_res)$/ { next }
  $2 == "quality" { print $4, $6, $3 > (prefix $1 ".presets") }
  # In order of time, so a setting is on the front when it is better than all before it.
  $1 != scene { scene = $1; least = "inf" }
  least == "inf" || $6 + 0 < least { least = $6 + 0; print $4, $6 > (prefix $1 ".front"); next }
  { print $4, $6 > (prefix $1 ".beaten") }'
{
  echo "set multiplot layout $rows,$columns title 'Every setting tried: error over time'"
  echo "set logscale xy; set grid; set format '%g'; set xlabel 'CPU seconds' offset 0,0.5"
  echo "set key bottom left samplen 1"
  for scene in $scenes; do
    echo "set title '$(title "$scene")'; set ylabel 'displayed RMSE, of 255' offset 1.5"
    lines=
    [ -f "$work/pareto.$scene.beaten" ] && lines=", '$work/pareto.$scene.beaten' pt 7 ps .35 lc rgb '#b0b0b0' title 'dominated'"
    lines="$lines, '$work/pareto.$scene.front' with steps lw 1.5 lc rgb '#2060c0' title 'front'"
    [ -f "$work/pareto.$scene.presets" ] && lines="$lines, '$work/pareto.$scene.presets' pt 9 ps 1.2 lc rgb '#d03020' title 'presets', '' using 1:2:3 with labels offset 0,1 textcolor rgb '#d03020' notitle"
    echo "plot ${lines#, }"
  done
  echo "unset multiplot"
} | draw pareto "$width" "$height"

# 3
awk -F, -v prefix="$work/claims." '
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  $at["claimed"] > 0 && $at["display"] > 0 {
    of_two = $at["knob"] ~ /^(error|adaptive)$/ || $at["options"] ~ /-error/ || $at["value"] ~ /^(preview|final|reference)$/
    # An estimate is about noise; it cannot know the bias of truncation.
    is_cut = $at["options"] ~ /roulette off/ || $at["options"] !~ /max_depth 100/ || $at["knob"] == "quality"
    method = is_cut ? "cut" : of_two ? "streams" : "halves"
    print $at["display"], $at["claimed"] > (prefix method)
    ++n[method]
    ratio = $at["claimed"] / $at["display"]
    near[method] += ratio > 0.9 && ratio < 1.1
  }
  END { for (m in n) print m, n[m], int(100 * near[m] / n[m] + 0.5) > (prefix "shares") }' "$csv"
share() { sed -n "s/^$1 [0-9]* //p" "$work/claims.shares"; }
{
  echo "set title 'Estimated over true error, one dot per render'"
  echo "set logscale xy; set grid; set key top left Left reverse; set size square"
  echo "set xlabel 'true displayed RMSE, of 255'; set ylabel 'estimated'; set xrange [0.1:100]; set yrange [0.1:100]"
  echo "set style fill solid 0.25 noborder"
  lines="'+' using 1:(0.9*\$1):(1.1*\$1) with filledcurves lc rgb '#80a080' title 'within 10 %', x with lines lc rgb '#404040' notitle"
  [ -f "$work/claims.cut" ] && lines="$lines, '$work/claims.cut' pt 7 ps .25 lc rgb '#c8c8c8' title 'with depth or throughput truncated, which no estimate knows'"
  [ -f "$work/claims.halves" ] && lines="$lines, '$work/claims.halves' pt 7 ps .25 lc rgb '#c08030' title 'from halves (conservative): $(share halves) % within'"
  [ -f "$work/claims.streams" ] && lines="$lines, '$work/claims.streams' pt 7 ps .4 lc rgb '#2060c0' title 'from two streams: $(share streams) % within'"
  echo "plot $lines"
} | draw claims 760 760

# 4
if [ -f "$features" ] && [ "$(wc -l < "$features")" -gt 1 ]; then
  bars=$(($(wc -l < "$features") - 2))
  {
    echo "set multiplot layout 2,1 title 'Cost of a feature in scenes that do not use it, against a program built without it'"
    echo "set datafile separator ','; set style fill solid 0.8 noborder; set boxwidth 0.7; set grid ytics;"
    echo "set key outside top right horizontal; set xtics rotate by -35 font ',8' noenhanced; set lmargin 8; set rmargin 8"
    echo "set title 'instructions per sample, 0.5 % allowed'; set ylabel 'percent more'"
    echo "name(row) = stringcolumn(1).', '.stringcolumn(2)"
    echo "plot [-0.6:$bars.6][-0.5:2] '$features' using 0:5:xtic(name(0)) every ::1 with boxes lc rgb '#2060c0' notitle, 0.5 lc rgb '#d03020' dt 2 notitle"
    echo "set title 'CPU seconds, median of the ratios with the range from 10 to 90 %, 1 % allowed'"
    echo "plot [-0.6:$bars.6][*:*] '$features' using 0:6:7:8:xtic(name(0)) every ::1 with yerrorbars pt 7 lc rgb '#c08020' notitle, 1 lc rgb '#d03020' dt 2 notitle"
    echo "unset multiplot"
  } | draw features 900 760
else
  echo "$features does not exist: no plot of unused features; script/price_of_features.sh measures it"
fi

# 5
awk -F'\t' -v prefix="$work/accel." '
  $2 == "accel" { print "\"" $3 "\"", $8, $9 > (prefix $1) }
  $2 == "accel_res" { print "\"" $3 "\"", $8, $9 > (prefix $1) }
  $2 ~ /^accel/ { primitives[$1] = $10 }
  END { for (s in primitives) print s, primitives[s] > (prefix "primitives") }' "$work/settings.tsv"
if [ -s "$work/accel.primitives" ]; then
  with=$(sort -k2,2n "$work/accel.primitives" | cut -d' ' -f1)
  {
    echo "set multiplot layout $rows,$columns title 'Seconds to build and to trace, by accelerator and its resolution'"
    echo "set style fill solid 0.85 noborder; set boxwidth 0.8; set logscale y; set format y '%g';"
    echo "set grid ytics; set xtics rotate by -55 scale 0 font ',8'; set key outside top right horizontal samplen 1"
    for scene in $with; do
      primitives=$(sed -n "s/^$scene //p" "$work/accel.primitives")
      sort -k1,1 "$work/accel.$scene" > "$work/accel.sorted.$scene"
      echo "set title '$(title "$scene"), $primitives primitives'; set ylabel 'seconds' offset 1.5"
      # From the axis up both, the sum behind: with a logarithmic scale they cannot be stacked.
      echo "plot [*:*][1e-5:*] '$work/accel.sorted.$scene' using 0:(\$2+\$3):xtic(1) with boxes lc rgb '#80a0d0' title 'build and trace', '' using 0:2 with boxes lc rgb '#803020' title 'build'"
    done
    echo "unset multiplot"
  } | draw accelerators "$width" "$height"
fi
