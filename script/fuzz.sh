#!/bin/sh
# Runs the fuzz targets of make fuzz and prints a line for each: executions, seconds, inputs kept, findings.
#
#     script/fuzz.sh [-seconds N] [-build FOLDER] [target ...]
#
# Each target runs for N seconds (default 60; an hour in a night). Its inputs are in FOLDER/corpus/TARGET (default FOLDER
# build/fuzz), begun with the scenes, meshes and images of the tree and kept from run to run; what it finds is in
# FOLDER/findings, each a file that FOLDER/targets/TARGET runs again. RAYPRO names the program that makes some seeds (default
# build/raypro). Exit status 1: there are findings, or a target did not run.
set -eu
cd "$(dirname "$0")/.."
raypro=${RAYPRO:-build/raypro}
seconds=60 folder=build/fuzz
while [ $# -gt 0 ]; do
  case $1 in
    -seconds) seconds=$2 ;; -build) folder=$2 ;;
    *) break ;;
  esac
  shift 2
done
all=$(for file in fuzz/*.cpp; do basename "$file" .cpp; done)
[ $# -gt 0 ] || set -- $all
mkdir -p "$folder/findings"
for target in "$@"; do
  [ -x "$folder/targets/$target" ] || { echo "no target $folder/targets/$target; make fuzz builds them" >&2; exit 1; }
done

# The files that a target begins with. Formats that the first byte chooses get it.
seed() {
  corpus=$folder/corpus/$1
  [ ! -d "$corpus" ] || return 0
  mkdir -p "$corpus"
  case $1 in
    scn) cp scenes/*.scn writeup/scenes/*.scn "$corpus" ;;
    groningen_yaml) cp scenes/*.yaml scenes/*.yml "$corpus" ;;
    groningen_json | cs315) cp scenes/*.json "$corpus" ;;
    comp30019) cp scenes/comp30019/*.txt "$corpus" ;;
    images) for file in scenes/thumbnails/*.jpg scenes/textures/*; do
        [ "$(wc -c < "$file")" -gt 20000 ] || cp "$file" "$corpus"
      done ;;
    meshes)
      for file in scenes/meshes/*; do
        case $file in
          *.obj) byte=A ;; *.off) byte=B ;; *.ply) byte=C ;; *.ray) byte=D ;; *.stl) byte=E ;; *) continue ;;
        esac
        { printf %s $byte; head -c 4000 "$file"; } > "$corpus/$(basename "$file")"
      done ;;
    events) printf 'key S\nwait trace\ndrag left 10 10 90 40\nscreenshot a.png\n' > "$corpus/script" ;;
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
}

idle=0
printf '%-16s%12s%9s%9s%10s\n' target executions seconds inputs findings
for target in "$@"; do
  seed "$target"
  log=$folder/$target.log
  before=$(find "$folder/findings" -name "$target-*" | wc -l)
  "$folder/targets/$target" "$folder/corpus/$target" -max_total_time="$seconds" -max_len=8192 -timeout=10 -rss_limit_mb=2048 \
    -artifact_prefix="$folder/findings/$target-" -print_final_stats=1 > "$log" 2>&1 || true
  found=$(($(find "$folder/findings" -name "$target-*" | wc -l) - before))
  awk -v target="$target" -v found="$found" -v seconds="$seconds" -v inputs="$(find "$folder/corpus/$target" -type f | wc -l)" '
    /stat::number_of_executed_units/ { count = $2 }
    END { printf "%-16s%12d%9d%9d%10d\n", target, count, seconds, inputs, found; exit !count }' "$log" || idle=1
done
[ -z "$(find "$folder/findings" -type f)" ] && [ $idle = 0 ]
