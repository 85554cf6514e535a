#!/bin/sh
# Breaks renders off in every way there is, many times, and prints a line for each way: what was counted, the seconds,
# the result. The tests of the suite do the same a few times.
#
#     script/robustness.sh [-kills n] [-interrupts n] [-allocations n]
#
#   -kills n        SIGKILL over an old picture at a random moment, half of them while the new one is saved; default 1000
#   -interrupts n   SIGINT and SIGTERM at random moments, and SIGKILL and SIGINT with -resume after each; default 100
#   -allocations n  how often memory ends, once or from then on; default 1000
# Besides: full disks, limits of file sizes, folders that take nothing or are gone, readers that are gone, ten runs with
# one output, and a power failure after any call. RAYTESTS names the test program, RAYPRO the one that is broken off
# (default those of build/). Exit status 1: something was torn, lost, or ended otherwise than by an exit status.
set -eu
cd "$(dirname "$0")/.."
root=$(pwd)
kills=1000 interrupts=100 allocations=1000
while [ $# -gt 0 ]; do
  case $1 in
    -kills | -interrupts | -allocations)
      [ $# -gt 1 ] || { echo "$1 takes a value" >&2; exit 2; }
      eval "${1#-}=\$2"
      shift 2 ;;
    *) echo "unknown option $1; see the head of $0" >&2; exit 2 ;;
  esac
done
export RAYPRO_ROOT="$root" RAYPRO="${RAYPRO:-$root/build/raypro}"
export RAYTESTS_KILLS="$kills" RAYTESTS_SIGNALS="$interrupts" RAYTESTS_BREAKS="$interrupts" RAYTESTS_ALLOCATIONS="$allocations"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
trap 'exit 130' INT TERM

"${RAYTESTS:-build/raytests}" --gtest_filter='Extremes.L*:Interrupted.*:-*.L9_*' > "$log" 2>&1 || true
awk '
  /^\[ RUN/ { counted = "" }
  /^[0-9]+ / && !/ test/ { counted = $0 }
  /^\[ +(OK|FAILED|SKIPPED) +\] [^ ,]+ \([0-9]+ ms\)/ {
    result = /^\[ +OK/ ? "passed" : /^\[ +FAILED/ ? "FAILED" : "skipped"
    ++count[result]
    match($0, /\([0-9]+ ms/)
    seconds = substr($0, RSTART + 1) / 1000
    sub(/^\[[^]]*\] [A-Za-z]+\./, "")
    sub(/ \(.*/, "")
    printf "%-8s%8.1f s  %s%s\n", result, seconds, $0, counted == "" ? "" : ": " counted
  }
  END {
    printf "%d passed, %d failed, %d skipped\n", count["passed"], count["FAILED"], count["skipped"]
    exit count["FAILED"] > 0 || !count["passed"]
  }' "$log" || { grep -A12 ': Failure' "$log" | head -100 >&2; exit 1; }
