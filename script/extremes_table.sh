#!/bin/sh
# Runs the tests of tests/extremes/cases.txt and prints a line per case: its number, what it is, how many tests cover it,
# how many passed, failed and were skipped, and the milliseconds they took. Some minutes; RAYPRO_NIGHT=1 tries millions.
#
#     script/extremes_table.sh [number ...]
#
# TESTS names the test program (default build/raytests); programs are those of RAYPRO and RAYIMG (build/raypro...). Exit
# status 1: a test failed, or a case that is not open has none.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
tests=${TESTS:-$here/build/raytests}
export RAYPRO="${RAYPRO:-$here/build/raypro}" RAYIMG="${RAYIMG:-$here/build/rayimg}" RAYPRO_ROOT="$here"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

[ $# -gt 0 ] || set -- $(sed -n 's/^\([A-M][0-9]*\) .*/\1/p' "$here/tests/extremes/cases.txt")
filter=
# A number may stand behind others (D1_D2_); *.A1_* and *_A1_* do not match A11.
for number in "$@"; do filter=$filter*.${number}_*:*_${number}_*:; done
"$tests" --gtest_filter="$filter" > "$work/log" 2>&1 || true

awk -v wanted=" $* " '
  FNR == NR && match($0, /^\[ +(OK|FAILED|SKIPPED) +\] [^ ,]+ \([0-9]+ ms\)/) {
    result = $0 ~ /^\[ +OK/ ? "passed" : $0 ~ /^\[ +FAILED/ ? "failed" : "skipped"
    name = $0; sub(/^[^.]*[.]/, "", name); ms = name
    sub(/ .*/, "", name); sub(/.*\(/, "", ms); sub(/ .*/, "", ms)
    for (n = split(name, parts, "_"); n > 0; --n)
      if (parts[n] ~ /^[A-M][0-9]+$/) { ++count[parts[n], result]; took[parts[n]] += ms }
    next
  }
  FNR == NR || !/^[A-M][0-9]/ || !index(wanted, " " $1 " ") { next }
  !header++ { printf "%-5s%-76s%7s%7s%8s%9s\n", "case", "input", "passed", "failed", "skipped", "ms" }
  {
    text = $0; sub(/^[^ ]+ /, "", text)
    all = count[$1, "passed"] + count[$1, "failed"] + count[$1, "skipped"]
    printf "%-5s%-76s%7d%7d%8d%9d\n", $1, substr(text, 1, 75), count[$1, "passed"], count[$1, "failed"], \
           count[$1, "skipped"], took[$1]
    ++cases; is_open = text ~ /^open:/; open += is_open; if (!all && !is_open) ++missing
    passed += !count[$1, "failed"] && count[$1, "passed"]; bad += count[$1, "failed"] > 0
  }
  END {
    printf "%d cases: %d passed, %d failed, %d open, %d without a test\n", cases, passed, bad, open, missing
    exit bad || missing
  }' "$work/log" "$here/tests/extremes/cases.txt"
