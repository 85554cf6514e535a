#!/bin/sh
# Runs a test program in as many processes as there are cores, each with its share of the tests, and prints what failed
# or was skipped, and how many passed.
#
#     script/run_tests.sh PROGRAM [--gtest_filter=... and other options of GoogleTest]
#
# JOBS=1 runs all tests in one process and prints what GoogleTest prints. The complete output of each process is in
# PROGRAM.log-1, PROGRAM.log-2... Exit status 1: a test failed or a process broke down.
set -eu
program=$1
shift
jobs=${JOBS:-$(nproc 2> /dev/null || getconf _NPROCESSORS_ONLN)}
[ "$jobs" -gt 1 ] || exec "$program" "$@"

echo "the tests run in $jobs processes, whose output goes to $program.log-1..."
rm -f "$program".log-*
processes=
trap 'kill $processes 2> /dev/null || true' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
for i in $(seq "$jobs"); do
  GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$((i - 1)) "$program" "$@" > "$program.log-$i" 2>&1 < /dev/null &
  processes="$processes $!"
done
status=0
i=0
for process in $processes; do
  i=$((i + 1))
  wait "$process" && continue
  status=1
  # The last line counts the tests; where there is none, the process broke down in the test it had begun last.
  tail -n 1 "$program.log-$i" | grep -q '^[0-9]* passed,' || echo "broke down, see $program.log-$i: $(grep '^\[ RUN' "$program.log-$i" | tail -n 1)"
done
processes=

# Everything that a failed test printed, then the reasons of those that were skipped, and the sums.
for i in $(seq "$jobs"); do
  awk '/^\[ RUN/ { text = "" } { text = text $0 "\n" } /^\[  FAILED  \] .*ms\)$/ { printf "%s", text }' "$program.log-$i"
done
cat "$program".log-* | awk '
  /^skipped:$/ { is_reason = 1; next }
  /^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$/ { passed += $1; failed += $3; skipped += $5; is_reason = 0; next }
  is_reason { reasons = reasons $0 "\n" }
  END {
    if (reasons) printf "skipped:\n%s", reasons
    printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
  }'
exit $status
