#!/bin/sh
# Runs the fuzz targets of make fuzz and prints a line for each: executions and seconds of this run and of all runs,
# executions a second, inputs kept, findings.
#
#     script/fuzz.sh [-seconds N] [-executions N] [-build FOLDER] [target ...]
#
# Each target runs for N seconds, or until it has been executed N times in all its runs, whichever comes first; with
# -executions alone, for as long as that takes; with neither, for 60 seconds. One that has its executions is passed
# over: "-executions 10000000 -seconds 3600", night after night, brings each to ten million.
#
# Its inputs are in FOLDER/corpus/TARGET (default FOLDER build/fuzz): the scenes, meshes and images of the tree, and
# what was found to be new from run to run. What it finds is in FOLDER/findings, each a file that FOLDER/targets/TARGET
# runs again. Executions and seconds of all runs are in FOLDER/totals/TARGET; remove that to count anew. RAYPRO names
# the program that makes some seeds (default build/raypro). Exit status 1: there are findings, or a target did not run.
set -eu
cd "$(dirname "$0")/.."
raypro=${RAYPRO:-build/raypro}
seconds= executions= folder=build/fuzz
while [ $# -gt 0 ]; do
  case $1 in
    -seconds) seconds=$2 ;; -executions) executions=$2 ;; -build) folder=$2 ;;
    *) break ;;
  esac
  shift 2
done
all=$(for file in fuzz/*.cpp; do basename "$file" .cpp; done)
[ $# -gt 0 ] || set -- $all
[ -n "$seconds$executions" ] || seconds=60
mkdir -p "$folder/findings" "$folder/totals"
for target in "$@"; do
  [ -x "$folder/targets/$target" ] || { echo "no target $folder/targets/$target; make fuzz builds them" >&2; exit 1; }
done

# In bytes. A longer seed would be cut, and of most formats a file cut short is none at all.
longest=20000

# The files that a target begins with, each time, since formats change. Those that the first byte chooses get it.
seed() {
  corpus=$folder/corpus/$1
  mkdir -p "$corpus"
  case $1 in
    scn) cp scenes/*.scn writeup/scenes/*.scn "$corpus" ;;
    groningen_yaml) cp scenes/*.yaml scenes/*.yml scenes/groningen/*.yaml "$corpus" ;;
    groningen_json | cs315) cp scenes/*.json "$corpus" ;;
    comp30019) cp scenes/comp30019/*.txt "$corpus" ;;
    images) cp scenes/thumbnails/*.jpg scenes/textures/* tests/R2/samples/*.[behjp]* "$corpus" ;;
    meshes)
      for file in scenes/meshes/*; do
        case $file in
          *.obj) byte=A ;; *.off) byte=B ;; *.ply) byte=C ;; *.ray) byte=D ;; *.stl) byte=E ;; *) continue ;;
        esac
        { printf %s $byte; head -c 4000 "$file"; } > "$corpus/$(basename "$file")"
      done ;;
    materials)
      cp tests/source/parse/models/*.mtl "$corpus"
      printf 'newmtl a\nKd 1 .5 0\nmap_Kd -s 2 2 -o 0 .5 g.ppm\nbump -bm 2 g.ppm\nnewmtl b c\nnorm c.ppm\nTf 1 0 0\nd .5\n' \
        > "$corpus/maps" ;;
    events) printf 'key S\nwait trace\ndrag left 10 10 90 40\nscreenshot a.png\n' > "$corpus/script" ;;
    environments)  # of the smallest of each layout; light, and where to draw
      for size in '\001\000' '\003\003' '\002\003'; do
        printf "$size"'\200\200\000\000\200\077' > "$corpus/$(printf %s "$size" | tr -d '\\')"
      done ;;
    command_line) printf 'Ascene.scn\nout.png\n-width\n64\n-error\n2\n' > "$corpus/words" ;;
    # Those of a render with the settings that the target has; the checkpoint without its checksum.
    replay)
      "$raypro" scenes/sphere.scn "$corpus/picture.ppm" -report "$corpus/report" -quiet
      sed 's/"hash": "[0-9a-f]*"/"hash": "0123456789abcdef"/' "$corpus/report" > "$corpus/report.json"
      rm "$corpus/picture.ppm" "$corpus/report" ;;
    checkpoint)
      "$raypro" scenes/sphere.scn "$corpus/picture.ppm" -width 16 -height 16 -samples 8 -keep_checkpoint -quiet
      head -c -8 "$corpus/picture.ppm.checkpoint" > "$corpus/checkpoint"
      rm "$corpus"/picture.* ;;
    *) printf 0123456789 > "$corpus/digits" ;;
  esac
  find "$corpus" -type f -size "+${longest}c" -exec rm {} +
}

# With 8 MB of freed memory watched, where 256 are usual, memory stays in the processor's caches; four callers tell
# where it came from. Inputs that are fast are tried the more often, and nobody else adds any meanwhile. Together these
# make up to twice as many executions a second (measured). A finding run by itself is reported in full.
export ASAN_OPTIONS="quarantine_size_mb=8:malloc_context_size=4${ASAN_OPTIONS:+:$ASAN_OPTIONS}"

# Executions and seconds of all runs so far.
totals() { cat "$folder/totals/$1" 2> /dev/null || echo 0 0; }

# How many executions are left to do; -1 is no end.
left() {
  [ -n "$executions" ] || { echo -1; return; }
  totals "$1" | awk -v all="$executions" '{ printf "%.0f", (all > $1 ? all - $1 : 0) }'
}

run() {
  "$folder/targets/$1" "$folder/corpus/$1" -runs="$(left "$1")" -max_total_time="${seconds:-0}" -max_len=$longest \
    -timeout=10 -rss_limit_mb=2048 -reload=0 -entropic_scale_per_exec_time=1 \
    -artifact_prefix="$folder/findings/$1-" -print_final_stats=1
}

findings() { find "$folder/findings" -name "$1-*" | wc -l; }

idle=0
printf '%-16s%12s%9s%9s%9s%10s%14s%11s\n' target executions seconds a_second inputs findings in_all_runs seconds
for target in "$@"; do
  log=$folder/$target.log count=0 took=0 before=$(findings "$target")
  if [ "$(left "$target")" != 0 ]; then
    seed "$target"
    began=$(date +%s)
    run "$target" > "$log" 2>&1 || true
    took=$(($(date +%s) - began))
    # Where it was ended from outside, the last line of progress tells.
    count=$(awk '/^#[0-9]/ { n = substr($1, 2) } /number_of_executed_units/ { n = $2 } END { printf "%.0f", n }' "$log")
    [ "$count" != 0 ] || idle=1
    sum=$(totals "$target" | awk -v count="$count" -v took="$took" '{ printf "%.0f %d", $1 + count, $2 + took }')
    echo "$sum" > "$folder/totals/$target"
  fi
  printf '%-16s%12d%9d%9d%9d%10d%14d%11d\n' "$target" "$count" "$took" "$((count / (took > 0 ? took : 1)))" \
    "$(find "$folder/corpus/$target" -type f | wc -l)" "$(($(findings "$target") - before))" $(totals "$target")
done
[ -z "$(find "$folder/findings" -type f)" ] && [ $idle = 0 ]
