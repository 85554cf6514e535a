#!/bin/sh
# What accuracy costs: renders a dozen scenes with one setting varied at a time, and with random combinations of settings,
# and writes one CSV row per render: seconds, true and estimated errors. Then plots them (script/tradeoff_plots.sh).
#
#     script/tradeoff.sh [-small | -full] [-instructions] [-no_plots] [-size n] [-seeds n] [-search n] [scene ...]
#
#   -small          64x64 pixels, 2 seeds, up to 64 samples, 12 random settings per scene: some minutes (the default)
#   -full           128x128 pixels, 8 seeds, up to 1024 samples, 200 random settings, the preset `reference`: many hours
#   -instructions   also count the instructions of each render, with valgrind; 50 times as slow
#   scene           names of the table below; all, unless some are given
#
# It can be interrupted and started again: an existing row (the same scene, knob, value and seed) is not measured again.
# Remove the folder when the program has changed. OUT names the folder (default build/tradeoff), RAYPRO and RAYIMG the
# programs, REFERENCE the samples of the references.
#
# Columns: rmse is linear and free of the references' noise, being the root of mean (x - r1)(x - r2) over two independent
# references; negative where that mean is, when the picture is as good as they are. relmse, display (255ths), flip and
# bias (mean difference over the channels) are against the mean of both. claimed, claimed_low and claimed_high are the
# program's estimate of `display` and its interval. build_s, render_s and primitives are for the accelerators, options for
# repeating a row by hand. Everything runs on one thread. The references are not truncated; filters have references of their
# own, because they converge to different pictures.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
rayimg=${RAYIMG:-$here/build/rayimg}

kind=small
instructions=no
plots=yes
size= seeds= search=
while [ $# -gt 0 ]; do
  case $1 in
    -small) kind=small ;;
    -full) kind=full ;;
    -instructions) instructions=yes ;;
    -no_plots) plots=no ;;
    -size) size=$2; shift ;;
    -seeds) seeds=$2; shift ;;
    -search) search=$2; shift ;;
    -*) echo "tradeoff.sh: unknown option $1; see the top of the script" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
wanted=$*
if [ $kind = small ]; then
  : "${size:=64}" "${seeds:=2}" "${search:=12}" "${REFERENCE:=512}"
else
  : "${size:=128}" "${seeds:=8}" "${search:=200}" "${REFERENCE:=8192}"
fi
if [ $instructions = yes ] && ! command -v valgrind > /dev/null; then
  echo "tradeoff.sh: -instructions needs valgrind" >&2
  exit 1
fi
out=${OUT:-$here/build/tradeoff}/$kind
mkdir -p "$out/references"
csv=$out/tradeoff.csv
header=scene,knob,value,seed,samples,cpu_s,wall_s,rays,rmse,relmse,display,flip,claimed,claimed_low,claimed_high,bias
header=$header,instructions,build_s,render_s,primitives,options
[ -s "$csv" ] || echo "$header" > "$csv"
echo "size $size, references of $REFERENCE samples" > "$out/settings.new"
[ -f "$out/settings" ] || cp "$out/settings.new" "$out/settings"
if ! cmp -s "$out/settings" "$out/settings.new"; then
  echo "tradeoff.sh: $out was made with other settings: $(cat "$out/settings"); remove it, or name another folder with OUT" >&2
  exit 1
fi
rm "$out/settings.new"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# name | file | options of the scene
cat > "$work/scenes" <<'END'
hello|hello.scn|
texture|texture.scn|
specular|specular.scn|
refraction|refraction.scn|
smooth|smooth.scn|
mesh_formats|mesh_formats.scn|
depth|depth.scn|
area_light|area_light.scn|
emissive|emissive.scn|
lens|lens.scn|-aperture .12 -focus 5
direct|indirect.scn|
indirect|indirect.scn|-mode path
END
if [ -n "$wanted" ]; then
  for name in $wanted; do
    grep "^$name|" "$work/scenes" >> "$work/chosen" || { echo "tradeoff.sh: unknown scene '$name'; see the table in the script" >&2; exit 2; }
  done
  mv "$work/chosen" "$work/scenes"
fi

# The plan, one line per render: key, file, reference (its filter), options. Seed by seed, so that what is compared runs
# close together and an interruption leaves whole rounds.
awk -F'|' -v kind="$kind" -v seeds="$seeds" -v search="$search" '
  # The base that a setting is varied from: nothing is truncated, faint rays are subject to Russian roulette.
  function reset() {
    delete o
    o["max_depth"] = 100; o["min_luminance"] = 0.01; o["roulette"] = "on"; o["shadow_samples"] = 1
    o["samples"] = kind == "small" ? 16 : 64
  }
  function words(   text, i, name) {
    for (i = 1; i <= split("samples error adaptive sampler filter max_depth min_luminance roulette shadow_samples lights " \
                           "accel accel_res quality", names, " "); ++i) {
      name = names[i]
      if (name in o) text = text " -" name " " o[name]
    }
    return text
  }
  function run(knob, value) {
    printf "%s|%s|%s|%d|%s|%s|%s%s\n", scene, knob, value, seed, file, "filter" in o ? o["filter"] : "box", own, substr(words(), own == "" ? 2 : 1)
  }
  # Changes one option of the base and runs it.
  function turn(knob, value, name, setting) { reset(); o[name] = setting; run(knob, value) }
  # An even choice among the words of a list, from a generator that is the same with every awk.
  function pick(list,   n, parts) {
    n = split(list, parts, " ")
    state = (state * 16807) % 2147483647
    return parts[1 + int(state / 2147483647 * n)]
  }
  function each(list) { return split(list, v, " ") }

  { all[++count] = $0 }
  END {
    samples = kind == "small" ? "1 4 16 64" : "1 2 4 8 16 32 64 128 256 512 1024"
    for (seed = 1; seed <= seeds; ++seed) for (k = 1; k <= count; ++k) {
      split(all[k], fields, "|")
      scene = fields[1]; file = fields[2]; own = fields[3]
      for (i = 1; i <= each(samples); ++i) {
        turn("samples", v[i], "samples", v[i])
        reset(); o["samples"] = v[i]; o["sampler"] = "random"; run("sampler", "random " v[i])
        o["sampler"] = "stratified"; run("sampler", "stratified " v[i])
      }
      if (kind == "full" || scene ~ /^(hello|specular|texture)$/)
        for (i = 1; i <= each("box gaussian mitchell lanczos"); ++i) turn("filter", v[i], "filter", v[i])
      for (i = 1; i <= each("0 1 2 3 4 6 10"); ++i) turn("max_depth", v[i], "max_depth", v[i])
      for (i = 1; i <= each("0.003 0.01 0.03 0.1 0.3"); ++i) {
        turn("min_luminance", "roulette " v[i], "min_luminance", v[i])
        o["roulette"] = "off"; o["max_depth"] = 10; run("min_luminance", "cut " v[i])
      }
      for (i = 1; i <= each("2 4 16"); ++i) turn("shadow_samples", v[i], "shadow_samples", v[i])
      for (i = 1; i <= each("all one 4"); ++i) turn("lights", v[i], "lights", v[i])
      for (i = 1; i <= each("none graph grid octree bvh"); ++i) {
        # Testing thousands of primitives one by one takes half a minute and tells nothing new.
        if (v[i] != "none" || scene !~ /^(smooth|mesh_formats)$/) turn("accel", v[i], "accel", v[i])
      }
      for (i = 1; i <= each("grid:0.5 grid:2 grid:8 octree:1 octree:4 octree:16 bvh:1 bvh:2 bvh:8"); ++i) {
        split(v[i], pair, ":")
        reset(); o["accel"] = pair[1]; o["accel_res"] = pair[2]; run("accel_res", pair[1] " " pair[2])
      }
      for (i = 1; i <= each(kind == "small" ? "8 4 2" : "8 4 2 1 0.5"); ++i) {
        reset(); delete o["samples"]; o["error"] = v[i]; run("error", v[i])
        o["adaptive"] = "off"; run("adaptive", "off " v[i])
      }
      for (i = 1; i <= each(kind == "small" ? "draft preview final" : "draft preview final reference"); ++i) {
        delete o; o["quality"] = v[i]; run("quality", v[i])
      }
      state = 20071
      for (i = 1; i <= search; ++i) {
        reset()
        o["samples"] = pick(kind == "small" ? "1 2 4 8 16 32 64" : "1 2 4 8 16 32 64 128 256 512 1024")
        error = pick(kind == "small" ? "8 6 4 3 2 1.5" : "8 6 4 3 2 1.5 1 0.7 0.5 0.35 0.25")
        o["sampler"] = pick("sobol sobol sobol random stratified")
        o["max_depth"] = pick("0 1 2 3 4 6 10")
        o["min_luminance"] = pick("0.003 0.01 0.03 0.1 0.3")
        o["roulette"] = pick("on off")
        o["shadow_samples"] = pick("1 1 2 4")
        o["lights"] = pick("all all one 2")
        adaptive = pick("tile off")
        if (pick("samples samples error") == "error") { delete o["samples"]; o["error"] = error; o["adaptive"] = adaptive }
        run("search", i)
      }
    }
  }' "$work/scenes" > "$work/plan"

# Without the rows that are there.
awk -F, 'FNR == NR { done[$1 "|" $2 "|" $3 "|" $4]; next }
  { split($0, f, "|") } !((f[1] "|" f[2] "|" f[3] "|" f[4]) in done)' "$csv" "$work/plan" > "$work/todo"
total=$(wc -l < "$work/todo")
echo "$total renders to do, $(($(wc -l < "$work/plan") - total)) done before; writing to $csv"

render() {  # picture, file, options
  picture=$1 file=$2
  shift 2
  "$raypro" "$here/scenes/$file" "$picture" -width "$size" -height "$size" -quiet "$@"
}

# The references of a scene and filter, unless they are there: r1, r2 and their mean.
make_references() {  # scene, file, filter, options of the scene
  to=$out/references/$1.$3
  [ -f "$to.mean.pfm" ] && return
  echo "references of $1, filter $3"
  for i in 1 2; do
    # shellcheck disable=SC2086  # options are words
    render "$work/r$i.pfm" "$2" $4 -filter "$3" -samples "$REFERENCE" -seed "100000$i" -max_depth 100 -roulette on \
      -min_luminance 0.01 -shadow_samples 1
  done
  "$rayimg" merge "$work/r1.pfm" "$work/r2.pfm" -out "$work/mean.pfm" > /dev/null 2>&1
  mv "$work/r1.pfm" "$to.1.pfm"
  mv "$work/r2.pfm" "$to.2.pfm"
  mv "$work/mean.pfm" "$to.mean.pfm"
}

# The program's JSON has one key per line, indented by two spaces per level. Prints one row from a report and two comparisons.
row() {  # scene, knob, value, seed, instructions, options
  awk -v key="$1,$2,$3,$4" -v instructions="$5" -v options="$6" '
    FNR == 1 { ++file }
    {
      match($0, /^ */)
      depth = RLENGTH / 2
      line = substr($0, RLENGTH + 1)
      sub(/,$/, "", line)
      if (match(line, /^"[^"]*": /)) {
        path[depth] = substr(line, 2, RLENGTH - 4)
        line = substr(line, RLENGTH + 1)
      } else {
        --depth  # an element of a list goes by the name of the list
      }
      name = file
      for (i = 1; i <= depth; ++i) name = name "." path[i]
      if (line ~ /^[\[{\]}]/) next
      if (name in value) value[name] = value[name] " " line
      else value[name] = line
    }
    function number(name) { return name in value && value[name] != "null" ? value[name] : "" }
    function root(square) { return square == "" ? "" : square < 0 ? -sqrt(-square) : sqrt(square) }
    END {
      split(value["3.bias"], bias, " ")
      # Claims are kept only in the unit of the column `display`.
      claims = value["1.error.unit"] == "\"255ths\""
      printf "%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n", key, number("1.samples.mean"), number("1.seconds.cpu"),
        number("1.seconds.wall"), number("1.rays.total"), root(number("2.two_reference_mse")),
        number("3.relative_mse"), number("3.display_rmse"), number("3.flip"), claims ? number("1.error.estimate") : "",
        claims ? number("1.error.low") : "", claims ? number("1.error.high") : "", (bias[1] + bias[2] + bias[3]) / 3,
        instructions, number("1.seconds.build"), number("1.seconds.render"), number("1.scene.primitives"), options
    }' "$work/report.json" "$work/product.json" "$work/mean.json"
}

count_instructions() {  # file, options
  file=$1
  shift
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$raypro" "$here/scenes/$file" "$work/counted.pfm" \
    -width "$size" -height "$size" -quiet -simd avx2 -threads 1 "$@" 2>&1 |
    sed -n 's/.*Collected *: *\([0-9]*\).*/\1/p'
}

n=0
while IFS='|' read -r scene knob value seed file filter options; do
  n=$((n + 1))
  [ $((n % 100)) != 0 ] || echo "$n of $total"
  own=$(sed -n "s/^$scene|[^|]*|//p" "$work/scenes")
  make_references "$scene" "$file" "$filter" "$own" < /dev/null
  truth=$out/references/$scene.$filter
  # shellcheck disable=SC2086  # options are words
  if ! render "$work/out.pfm" "$file" $options -seed "$seed" -threads 1 -report "$work/report.json" < /dev/null; then
    echo "failed: $scene $options -seed $seed" >&2
    continue
  fi
  "$rayimg" diff "$work/out.pfm" "$truth.1.pfm" -reference2 "$truth.2.pfm" -json > "$work/product.json"
  "$rayimg" diff "$work/out.pfm" "$truth.mean.pfm" -json > "$work/mean.json"
  counted=
  # shellcheck disable=SC2086
  [ $instructions = no ] || counted=$(count_instructions "$file" $options -seed "$seed" < /dev/null)
  row "$scene" "$knob" "$value" "$seed" "$counted" "$options" >> "$csv"
done < "$work/todo"

[ $plots = no ] || sh "$here/script/tradeoff_plots.sh" "$csv"
