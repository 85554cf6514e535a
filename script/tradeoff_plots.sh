#!/bin/sh
# Summarizes what script/tradeoff.sh measured: prints which presets are dominated, and draws charts as SVG beside the CSV,
# with a page, index.html, that shows them all.
#
#     script/tradeoff_plots.sh [tradeoff.csv]
#
#   pareto.SCENE        every setting tried, displayed error over CPU seconds; gray ones are dominated in time and error by
#                       another, and presets have names; the page names the settings that none dominates
#   rays.SCENE          the same over rays, which no busy machine changes
#   samplers.SCENE      linear RMSE over samples, one line per sampler; slopes are from 4 samples up
#   claims              estimated over true error, one dot per render, by how the estimate was made
#   accelerators.SCENE  seconds to trace over seconds to build, one thread
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
csv=${1:-$here/build/tradeoff/small/tradeoff.csv}
out=$(dirname "$csv")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Sums the seeds of every setting up: scene, knob, value, cpu_s (median), rmse (root of the mean square), display (the
# same), samples, build_s and render_s (medians), primitives, rays, options.
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
    options[key] = $at["options"]; samples[key] += $at["samples"]; rays[key] += $at["rays"]; primitives[key] = $at["primitives"]
  }
  END {
    for (i = 1; i <= count; ++i) {
      k = order[i]
      m = square[k] / n[k]
      print k, median(cpu[k]), (m > 0 ? sqrt(m) : "nan"), sqrt(display[k] / n[k]), samples[k] / n[k], median(build[k]), \
        median(trace[k]), primitives[k], rays[k] / n[k], options[k]
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

plot() { awk -v width="${2:-480}" -v height="${3:-400}" -f "$here/script/plot.awk" > "$out/$1.svg"; }
title() { echo "$1" | tr _ ' '; }
scenes=$(cut -f1 "$work/settings.tsv" | awk '!seen[$0]++')

# Filters converge to other images and accelerators to the same one, so neither is part of the trade-off. In order of
# cost, a setting is on the front when it is better than all before it.
pareto() {  # scene, column of the cost, its name
  sort -t"	" -k"$2,$2g" -k6,6g "$work/settings.tsv" | awk -F'\t' -v scene="$1" -v column="$2" -v axis="$3" -v title="$(title "$1")" '
    $1 != scene || $2 ~ /^(filter|accel|accel_res)$/ { next }
    $2 == "quality" { presets = presets $column "\t" $6 "\t" $3 "\n" }
    !found++ || $6 + 0 < least { least = $6 + 0; front = front $column "\t" $6 "\n"; next }
    { beaten = beaten $column "\t" $6 "\n" }
    END {
      printf "title\t%s\nx\t%s\ny\tdisplayed error, of 255\nkey\tbottom\n", title, axis
      printf "series\tdominated\tpoints\t0\n%sseries\tdominated by none\tsteps\t1\n%s", beaten, front
      printf "series\tpresets\tlabels\t4\n%s", presets
    }'
}
# Those settings as a table of the page.
front() {
  sort -t"	" -k4,4g -k6,6g "$work/settings.tsv" | awk -F'\t' -v scene="$1" '
    $1 != scene || $2 ~ /^(filter|accel|accel_res)$/ { next }
    !found++ || $6 + 0 < least {
      least = $6 + 0
      printf "<tr><td>%.3g</td><td>%.3g</td><td><code>%s</code></td></tr>\n", $4, $6, $12
    }'
}
samplers() {
  awk -F'\t' -v scene="$1" -v title="$(title "$1")" '
    $1 != scene || ($2 != "samples" && $2 != "sampler") || $5 == "nan" { next }
    {
      name = $2 == "samples" ? "sobol" : $3
      sub(/ .*/, "", name)
      data[name] = data[name] $7 "\t" $5 "\n"
      if ($7 < 4) next
      x = log($7); y = log($5)
      ++n[name]; sx[name] += x; sy[name] += y; sxx[name] += x * x; sxy[name] += x * y
    }
    END {
      printf "title\t%s\nx\tsamples per pixel\ny\tlinear RMSE\nkey\tbottom\n", title
      count = split("sobol stratified random", names, " ")
      for (i = 1; i <= count; ++i) {
        name = names[i]
        if (data[name] == "") continue
        below = n[name] * sxx[name] - sx[name] ^ 2
        slope = below > 0 ? sprintf(" %.2f", (n[name] * sxy[name] - sx[name] * sy[name]) / below) : ""
        printf "series\t%s%s\tline\t%d\n%s", name, slope, i, data[name]
      }
    }' "$work/settings.tsv"
}
accelerators() {
  awk -F'\t' -v scene="$1" -v title="$(title "$1")" '
    $1 == scene && $2 ~ /^accel(_res)?$/ && $8 > 0 { data = data $8 "\t" $9 "\t" $3 "\n"; primitives = $10 }
    END {
      if (data != "")
        printf "title\t%s, %d primitives\nx\tseconds to build\ny\tseconds to trace\nseries\t\tlabels\t1\n%s", title, primitives, data
    }' "$work/settings.tsv"
}

# An estimate is about noise; it cannot know the bias of what depth and throughput cut off.
awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  $at["claimed"] > 0 && $at["display"] > 0 {
    of_two = $at["knob"] ~ /^(error|adaptive)$/ || $at["options"] ~ /-error/ || $at["value"] ~ /^(preview|final|reference)$/
    is_cut = $at["options"] ~ /roulette off/ || $at["options"] !~ /max_depth 100/ || $at["knob"] == "quality"
    method = is_cut ? 0 : of_two ? 1 : 2
    data[method] = data[method] $at["display"] "\t" $at["claimed"] "\n"
    ++n[method]
    ratio = $at["claimed"] / $at["display"]
    near[method] += ratio > 0.9 && ratio < 1.1
  }
  END {
    print "title\tEstimated over true error\nx\ttrue error, of 255\ny\testimated error, of 255\nband\twithin 10 %\t.9\t1.1"
    split("from two streams,from halves of one", names, ",")
    if (n[0]) printf "series\tdepth or throughput cut off\tpoints\t0\n%s", data[0]
    for (m = 2; m >= 1; --m)
      if (n[m]) printf "series\t%s: %.0f %% within\tpoints\t%d\n%s", names[m], 100 * near[m] / n[m], m, data[m]
  }' "$csv" | plot claims 760 640

for scene in $scenes; do
  pareto "$scene" 4 'CPU seconds' | plot "pareto.$scene"
  pareto "$scene" 11 rays | plot "rays.$scene"
  samplers "$scene" | plot "samplers.$scene"
  accelerators "$scene" > "$work/accelerators"
  [ ! -s "$work/accelerators" ] || plot "accelerators.$scene" < "$work/accelerators"
done

figure() { [ ! -f "$out/$1.svg" ] || echo "<img src=\"$1.svg\" alt=\"$2\">"; }
{
  echo '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
  echo '<title>What accuracy costs</title><style>:root{color-scheme:light dark}body{font-family:sans-serif;margin:2em}'
  echo 'td{padding:.1em .8em}img{max-width:100%}</style><h1>What accuracy costs</h1>'
  figure claims 'Estimated over true error'
  for scene in $scenes; do
    echo "<h2>$(title "$scene")</h2>"
    figure "pareto.$scene" 'Error over CPU seconds'
    figure "rays.$scene" 'Error over rays'
    figure "samplers.$scene" 'Error over samples, by sampler'
    figure "accelerators.$scene" 'Seconds to trace over seconds to build'
    echo '<table><tr><th>CPU s</th><th>error, of 255</th><th>settings that no other dominates</th></tr>'
    front "$scene"
    echo '</table>'
  done
} > "$out/index.html"
echo "$out/index.html"
