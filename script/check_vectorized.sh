#!/bin/sh
# Fails if g++ makes no vector instructions of a function marked R3_VECTORIZED: small changes to what a loop calls are
# enough for that, a structure copied where its members used to be, and nothing else tells. Prints each function that
# is left plain loops.
#
#     script/check_vectorized.sh [CXX]
set -eu
cd "$(dirname "$0")/.."
cxx=${1:-g++}
remarks=$(mktemp)
trap 'rm -f "$remarks"' EXIT
status=0
compiled=
for file in $(grep -rlE '^ *R3_VECTORIZED' R1 R2 R3 source --include='*.cpp' | sort); do
  object=build/vectorized/obj/$(dirname "$file")/all.o
  if [ "$object" != "$compiled" ]; then
    rm -f "$object"
    make -s BUILD=build/vectorized CXX="$cxx" CXXFLAGS=-fopt-info-vec-optimized "$object" 2> "$remarks" > /dev/null ||
      { cat "$remarks" >&2; exit 1; }
    compiled=$object
  fi
  # Remarks: "./file:line:column: optimized: loop vectorized using 32 byte vectors". A function without a loop has those
  # of what it calls, which stand elsewhere in the file.
  awk -v file="$file" '
    FILENAME == ARGV[1] {
      if (split($0, part, ":") > 3 && substr(part[1], length(part[1]) - length(file) + 1) == file &&
          /loop vectorized using (32|64) byte/) is_vectorized[part[2]] = 1
      next
    }
    FNR == 1 { for (line in is_vectorized) ++all }
    /^ *R3_VECTORIZED/ {
      match($0, /^ */); indent = RLENGTH; start = FNR; found = loops = 0
      name = $0; sub(/^ *R3_VECTORIZED */, "", name)
      next
    }
    start {
      if (name == "") { name = $0; sub(/^ */, "", name) }
      loops += / for \(/
      found += FNR in is_vectorized
      if (match($0, /^ *}/) && RLENGTH == indent + 1) {
        if (!(loops ? found : all)) { print file ":" start ": not vectorized: " name; failed = 1 }
        start = 0
      }
    }
    END { exit failed }' "$remarks" "$file" || status=1
done
exit $status
