#!/bin/sh
# Regenerates the writeup from the repository: every picture, table and plot, and its pages.
#
#     script/runray.sh [-accept] [-all] [ID ...]     everything, or the pictures named
#     script/runray.sh -fast                         a check: a few small pictures and the pages, below build/ only
#
# script/pictures.txt lists the pictures, writeup/text/ holds the text, script/page.awk combines both. A picture is
# rendered again if its scene, what that includes, its options or the program changed since this machine last made it
# (-all: always); build/writeup records what was made. A picture whose scene and options are those of the stored
# one must match it: at most PERCENT (1) of the pixels may differ by more than LARGEST (0.04). Otherwise it is
# listed, the stored one stays, and the exit status is 1; -accept takes the new ones. Pictures that cannot be made here,
# because rayview or the bench is missing, stay as they are.
#
# RAYPRO, RAYIMG, RAYVIEW, KERNELS and TESTS name the programs, JOBS how many pictures are made in parallel (default: the
# number of processors). Seconds are CPU seconds of one thread.
set -eu
cd "$(dirname "$0")/.."
export RAYPRO="${RAYPRO:-build/raypro}" RAYIMG="${RAYIMG:-build/rayimg}" RAYVIEW="${RAYVIEW:-build/rayview}"
export LARGEST="${LARGEST:-0.04}" PERCENT="${PERCENT:-1}" LC_ALL=C
table=script/pictures.txt
build=build/writeup
pictures=writeup/pictures
measured=writeup/measured
texts="assignment3 shapes light surfaces camera viewer accuracy courses troubleshooting"

# Rows of the table without comments; fields are parted by tabs.
rows() { awk -F ' *[|] *' -v OFS='\t' '/^#/ || NF < 7 { next } { $1 = $1; print }' $table; }

# The table as rows() gives it is kept in a file, for the many that ask.
field() { awk -F '\t' -v id="$1" -v n="$2" '$1 == id { print $n; exit }' "$build/rows"; }

# A scene and all files it names, and those they name; words that are no files are skipped.
inputs_of() {  # file
  echo "$1"
  case $1 in *.scn | *.yaml | *.yml | *.json | *.txt) ;; *) return 0 ;; esac
  folder=$(dirname "$1")
  # In YAML, JSON and COMP30019's text names stand in quotes or between commas and brackets.
  for word in $(sed "s/#.*//; s/[][{}(),\"']/ /g" "$1" | tr -s ' \t' '\n\n' | grep '[a-z]\.[a-z]' | sort -u); do
    if [ -f "$folder/$word" ]; then (inputs_of "$folder/$word"); fi
  done
}

number() {  # file, name: its last value in the report
  sed -n "s/.*\"$2\": *\([0-9.e+-]*\).*/\1/p" "$1" | tail -1
}

# What a picture is kept as: JPEG, but PNG where single pixels are looked at.
file_of() {  # id, program, options
  case "$2 $3" in
    text*) echo "$1.txt" ;;
    *-crop* | *-mode\ id*) echo "$1.png" ;;
    *) echo "$1.jpg" ;;
  esac
}

# Rayview, or what runs it, has not made the picture $id: a failure only where it can draw at all.
rayview_failed() {
  "$RAYVIEW" scenes/empty.scn -headless > /dev/null 2>&1 ||
    { echo "  $id: rayview cannot draw here, kept as it is"; return 0; }
  cat "$build/$id.said"
  echo "$id cannot be made" >> $build/failures
  return 1
}

# One row: made if it must be, compared, noted. Prints a line; ends with status 1 when it is not what is stored.
make_one() {  # id
  id=$1
  program=$(field "$id" 3) scene=$(field "$id" 4) options=$(field "$id" 5)
  section=$(field "$id" 2)
  case $scene in */*) ;; *) scene=scenes/$scene.scn ;; esac
  file=$(file_of "$id" "$program" "$options")
  size="-width 640 -height 480"
  events=
  tool=$RAYPRO
  case $program in
    rayview | session) events=writeup/views/$id.events tool=$RAYVIEW ;;
    text) size="-width 320 -height 240" ;;
  esac
  case $options in *-width*) size= ;; esac
  [ -x "$tool" ] || { echo "  $id: no $tool here, kept as it is"; return 0; }
  folder=$pictures
  case $program in text*) folder=$measured ;; esac
  stored=$folder/$file new=$build/$file

  files=$(inputs_of "$scene" | sort -u)
  # The name is a part of what goes in, the contents another.
  inputs=$({ echo "$program $scene $options"; cat $files $events; } | cksum | cut -d ' ' -f 1)
  stamp="$inputs $(cksum < "$tool")"
  if [ "$all" = no ] && [ -f "$build/$id.row" ] && [ "$(cat "$build/$id.stamp" 2> /dev/null)" = "$stamp" ]; then
    case $program in
      same*) return 0 ;;
      *) if [ -f "$stored" ]; then return 0; fi ;;
    esac
  fi
  rm -f "$build/$id.stamp"
  case $program in
    rayview)
      # What a script traces is thrown away; the program says on its own output what it shows.
      "$tool" "$scene" -headless $size $options -events "$events" -image "$build/$id.traced.png" \
        -screenshot "$new" > "$build/$id.said" 2>&1 ||
        { rayview_failed; return; }
      row=",,,,,,,,," ;;
    session)
      script/session.sh "$events" "$scene" "$build/$id.avi" -last "$new" $size $options > "$build/$id.said" 2>&1 ||
        { rayview_failed; return; }
      row=",,,,,,,,," ;;
    text)
      "$tool" "$scene" $size $options > "$build/$id.said" 2>&1 ||
        { cat "$build/$id.said"; echo "$id cannot be made" >> $build/failures; return 1; }
      awk 'NR > 14 { print "..."; exit } { print }' "$build/$id.said" > "$new"
      row=",,,,,,,,," ;;
    *)
      "$tool" "$scene" "$new" $size -jpeg_quality 88 -threads 1 $options -quiet -report "$build/$id.json" \
        2> "$build/$id.said" ||
        { cat "$build/$id.said"; echo "$id cannot be made" >> $build/failures; return 1; }
      r=$build/$id.json
      rays=$(sed -n 's/.*"total": *\([0-9]*\).*/\1/p' "$r" | head -1)
      row="$(number "$r" cpu),$(number "$r" build),$rays,$(number "$r" node_visits),$(number "$r" box_tests)"
      row="$row,$(number "$r" primitive_tests),$(number "$r" cache_tests),$(number "$r" cache_hits)"
      row="$row,$(number "$r" structure_bytes),$(sed -n '/"primitives"/{s/.*: *\([0-9]*\).*/\1/p;q;}' "$r")" ;;
  esac

  verdict=new
  case $program in
    same*)
      # The same bits, so the same bytes but for what the file tells about its making.
      other=${program#same } extension=${file##*.}
      "$RAYIMG" diff "$new" "$build/$other.$extension" -fail 0 > /dev/null ||
        { echo "  $id: DIFFERS from $other"; echo "$id differs from $other" >> $build/failures; return 1; }
      verdict="the same as $other" ;;
    *)
      old=$(awk -F, -v id="$id" '$1 == id { print $2 }' $measured/pictures.csv 2> /dev/null || true)
      if [ ! -f "$stored" ]; then
        replaces=yes
      elif [ "$old" != "$inputs" ]; then
        verdict="new, its scene or options changed" replaces=yes
      elif [ "$program" = text ]; then
        if cmp -s "$new" "$stored"; then verdict="as stored" replaces=no; else replaces=no verdict=differs; fi
      elif "$RAYIMG" diff "$new" "$stored" -fail "$LARGEST" -fail_percent "$PERCENT" > "$build/$id.diff"; then
        verdict="as stored" replaces=no
      else
        verdict=differs replaces=no
      fi
      if [ "$verdict" = differs ]; then
        if [ "$accept" = yes ]; then
          verdict="differs, accepted" replaces=yes
        else
          echo "  $id: DIFFERS from $stored; see $build/$file"
          echo "$id differs from $stored" >> $build/failures
          return 1
        fi
      fi
      if [ "$replaces" = yes ]; then
        if [ "$fast" = yes ]; then echo "$id is not stored" >> $build/failures; return 1; fi
        cp "$new" "$stored"
      fi ;;
  esac
  echo "$id,$inputs,$row" > "$build/$id.row"
  echo "$stamp" > "$build/$id.stamp"
  printf '  %-22s %8s s  %s\n' "$id" "$(echo "$row" | awk -F, '{ if ($1 != "") printf "%.2f", $1 }')" "$verdict"
}

# What is measured once for the tables, unless the program is the one that it was measured with.
is_measured() {  # name, program
  [ "$all" = no ] && [ -f "$measured/$1.csv" ] && [ "$(cat "$build/$1.measured" 2> /dev/null)" = "$(cksum < "$2")" ]
}

# Presets and -error against two references with other seeds: estimated and true errors.
measure_claims() {
  is_measured claims "$RAYPRO" && return 0
  echo "estimated and true errors"
  echo "scene,setting,samples,cpu_s,estimated,low,high,true" > $build/claims.csv
  for scene in hello area_light lens; do
    extra=
    [ $scene != lens ] || extra="-aperture 0.12 -focus 5"
    common="-width 64 -height 48 -shadow_samples 1 $extra -quiet"
    # Nothing is cut off in them, as in the presets.
    for seed in 1001 1002; do
      "$RAYPRO" scenes/$scene.scn $build/reference$seed.pfm $common -max_depth 20 -roulette on -samples 512 -seed $seed
    done
    for setting in "-quality draft" "-quality preview" "-quality final" "-error 4" "-error 2" "-error 1" \
      "-error 0.5"; do
      case $setting in -error*) more="-max_depth 20 -roulette on" ;; *) more= ;; esac
      "$RAYPRO" scenes/$scene.scn $build/claim.pfm $common $setting $more -threads 1 -report $build/claim.json \
        -reference $build/reference1001.pfm,$build/reference1002.pfm
      r=$build/claim.json
      printf '%s,%s' $scene "$setting"
      for name in mean cpu estimate low high true_error; do printf ',%s' "$(number $r $name)"; done
      echo
    done >> $build/claims.csv
  done
  cp $build/claims.csv $measured/claims.csv
  cksum < "$RAYPRO" > $build/claims.measured
}

# Mrays/s beside Embree's, if the bench is built and finds it.
measure_peer() {
  kernels=${KERNELS:-build/bench/kernels}
  [ -x "$kernels" ] || { echo "no $kernels (make bench): $measured/peer.csv stays"; return 0; }
  is_measured peer "$kernels" && return 0
  echo "rays per second, beside Embree if found"
  "$kernels" scene=colonnade,city accel=bvh,octree,grid rays=50000 repeats=3 > $build/peer.txt 2>&1 ||
    { tail -3 $build/peer.txt; echo "the bench failed: $measured/peer.csv stays"; return 0; }
  grep -q '^Embree' $build/peer.txt || { echo "no Embree here: $measured/peer.csv stays"; return 0; }
  # Rows are: scene, kind, Embree and its rate, then an accelerator, its rate and (ratio, wrong theirs + ours).
  awk '
    NR == 1 {
      sub(/;.*/, ""); peer = $0
      print "scene,rays,peer,peer_rate,accelerator,rate,ratio,wrong_peer,wrong_ours"
    }
    $3 == "Embree" {
      line = $0; rate = $4
      sub(/.*Embree +[0-9.]+ +/, "", line)
      while (match(line, /[a-z]+ +[0-9.]+ +\([^)]*\)/)) {
        split(substr(line, RSTART, RLENGTH), w, /[ (),]+/)
        print $1 "," $2 "," peer "," rate "," w[1] "," w[2] "," w[3] "," w[5] "," w[7]
        line = substr(line, RSTART + RLENGTH)
      }
    }' $build/peer.txt > $measured/peer.csv
  cksum < "$kernels" > $build/peer.measured
}

# The tests of extremes except the statistical ones, which take minutes: each claim and its result.
measure_extremes() {
  tests=${TESTS:-build/raytests}
  [ -x "$tests" ] || { echo "no $tests (make test-binary): $measured/extremes.csv stays"; return 0; }
  is_measured extremes "$tests" && return 0
  echo "tests of extremes"
  families=$(for family in A B C D E J L M; do printf 'Extremes.%s*:' $family; done)
  RAYPRO=$PWD/$RAYPRO RAYIMG=$PWD/$RAYIMG RAYPRO_ROOT=$PWD "$tests" --gtest_filter="$families" \
    > $build/extremes.txt 2>&1 ||
    echo "some tests of extremes fail; the page says so"
  awk 'BEGIN { print "test,result,ms" }
    /^\[ +(OK|FAILED|SKIPPED) +\] Extremes\.[^,]* \(/ {
      result = $0 ~ /OK/ ? "passed" : $0 ~ /FAILED/ ? "failed" : "skipped"
      name = $0; sub(/.*Extremes\./, "", name); sub(/ .*/, "", name)
      ms = $0; sub(/.*\(/, "", ms); sub(/ ms.*/, "", ms)
      print name "," result "," ms
    }' $build/extremes.txt > $measured/extremes.csv
  cksum < "$tests" > $build/extremes.measured
}

# Estimated over true errors with their intervals; one dot per render.
plot() {
  awk -F, '
    BEGIN { print "x\ttrue error, of 255\ny\testimated error, of 255\nband\twithin 10 %\t.9\t1.1" }
    NR > 1 {
      if (!($1 in of_scene)) order[++n] = $1
      of_scene[$1] = of_scene[$1] $8 "\t" $5 "\t\t" $6 "\t" $7 "\n"
    }
    END { for (i = 1; i <= n; ++i) printf "series\t%s\tpoints\t%d\n%s", order[i], i, of_scene[order[i]] }
  ' $measured/claims.csv | awk -v width=640 -v height=480 -f script/plot.awk > $build/claims.svg
  cp $build/claims.svg $pictures/claims.svg
}

pages() {  # folder to write to
  for page in $texts; do
    awk -v page=$page -v measured=$measured -f script/page.awk $table writeup/text/$page.html > "$1/$page.html.new"
    mv "$1/$page.html.new" "$1/$page.html"
  done
}

all=${RUNRAY_ALL:-no} accept=${RUNRAY_ACCEPT:-no} fast=${RUNRAY_FAST:-no}
while [ $# -gt 0 ]; do
  case $1 in
    -all) all=yes ;;
    -accept) accept=yes ;;
    -fast) fast=yes all=yes ;;
    -one)
      [ $# = 2 ] || exit 0  # xargs without words
      [ "$fast" = no ] || build=$build/fast
      make_one "$2"
      exit ;;
    -*) echo "runray.sh: unknown option $1; see the top of the script" >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
[ "$fast" = no ] || build=$build/fast
export RUNRAY_ALL="$all" RUNRAY_ACCEPT="$accept" RUNRAY_FAST="$fast"
for program in "$RAYPRO" "$RAYIMG"; do
  [ -x "$program" ] || { echo "runray.sh: no $program; build it with make" >&2; exit 1; }
done
started=$(date +%s)
mkdir -p $build $pictures $measured
rm -f $build/failures
rows > $build/rows

wanted=$(awk -F '\t' -v fast="$fast" '$3 != "compare" && (fast == "no" || $2 == "fast") { print $1 }' $build/rows)
if [ $# -gt 0 ]; then
  for id; do echo "$wanted" | grep -qx -- "$id" || { echo "runray.sh: unknown picture '$id'; see $table" >&2; exit 2; }; done
  wanted=$(printf '%s\n' "$@")
fi
jobs=${JOBS:-$(getconf _NPROCESSORS_ONLN 2> /dev/null || echo 1)}
echo "$(echo "$wanted" | wc -l) pictures, $jobs at a time"
# Those that must equal another come after all others.
for pass in others same; do
  awk -F '\t' -v pass=$pass -v wanted="$wanted" '
    BEGIN { n = split(wanted, names, "\n"); for (i = 1; i <= n; ++i) is_wanted[names[i]] = 1 }
    is_wanted[$1] && ($3 ~ /^same/) == (pass == "same") { print $1 }' $build/rows |
    xargs -P "$jobs" -n 1 "$0" -one || [ -s $build/failures ] || echo "a picture cannot be made" >> $build/failures
done
if [ "$fast" = no ]; then
  {
    echo "id,inputs,cpu_s,build_s,rays,nodes,boxes,primitive_tests,asked_last,hit_last,bytes,primitives"
    for id in $(awk -F '\t' '$3 != "compare" { print $1 }' $build/rows); do
      if [ -f "$build/$id.row" ]; then cat "$build/$id.row"
      else grep "^$id," $measured/pictures.csv 2> /dev/null || true; fi
    done
  } > $build/pictures.csv
  cp $build/pictures.csv $measured/pictures.csv
  if [ $# = 0 ]; then
    measure_claims
    measure_peer
    measure_extremes
    plot
  fi
  pages writeup
else
  mkdir -p $build/page
  pages $build/page
  for page in $texts; do
    cmp -s $build/page/$page.html writeup/$page.html ||
      echo "writeup/$page.html is out of date" >> $build/failures
  done
fi
echo "$(($(date +%s) - started)) seconds"
if [ -s $build/failures ]; then
  echo "failures:"
  sed 's/^/  /' $build/failures
  exit 1
fi
