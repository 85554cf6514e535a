#!/bin/sh
# Runs every script of script/, as little as it can do, or names what else runs it; and looks for every command and
# target that pages and the Makefile list. Prints what fails. RAYPRO_NIGHT=1 runs those as well that take long.
#   usage: tests/scripts.sh [name ...]      RAYPRO, RAYIMG, RAYVIEW and RAYTESTS name the programs
set -eu
cd "$(dirname "$0")/.."
build=$(dirname "$RAYPRO")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset GTEST_TOTAL_SHARDS GTEST_SHARD_INDEX GTEST_SHARD_STATUS_FILE  # of the tests that run this
export RUNS=1 SIZES=160x120 OUT="$work" REFERENCE=8
echo "background 1 1 1" > "$work/white.scn"

# What this machine lacks is left out.
lacks() { command -v "$1" > /dev/null || echo "$2"; }
left_out="$([ -d ../shared ] || echo courses.sh) $(lacks patchelf tarball.sh)
  $([ -n "${RAYVIEW-}" ] || echo preview_difference.sh viewer_screens.sh)"

# The name of each, then its words, or "by" and the file that runs it, or "night" and its words.
cat > "$work/table" <<END
accelerator_choice.py night -width 8 -rounds 1 implicit
advice.py night $RAYPRO $work/white.scn
art.sh night -small glass
check_dist.sh night
check_english.sh by Makefile
check_functions.sh by tests/R1/Elementary.cpp
check_layers.sh by Makefile
check_packages.sh by Makefile
check_vectorized.sh night
claims_table.sh -seeds 1 -size 8 -references $work/claims hello
comp30019 -f scenes/comp30019/room.txt -o $work/room.png -w 16 -h 16
compare_accelerators.sh scenes/sphere.scn
courses.sh night ../shared
denoise_table.sh -size 8 -samples 2 -references $work/denoise hello
elementary.py by tests/R1/Elementary.cpp
extremes_table.sh M1
fuzz.sh by .github/workflows/weekly.yml
install.sh by make/install.mk
install_names.sh by script/install.sh
movie.sh by tests/app/movie.txt
mutations.sh -count 1 -list
other_architecture.sh night -emulator env -program $RAYPRO scenes/sphere.scn
preview_difference.sh -size 16 scenes/hello.scn
release.sh by tests/fresh/README.md
robustness.sh night -kills 1 -interrupts 1 -allocations 1
run_tests.sh by Makefile
runray.sh by Makefile
session.sh by script/runray.sh
setup.sh by .github/workflows/weekly.yml
tarball.sh $build $work
thumbnails.sh -check
time_scenes.sh -size 8 scenes/sphere.scn
mitsuba_times.py by script/time_to_error.sh
time_to_error.sh -size 8 -seconds 1 -references $work/time room
tradeoff.sh -size 8 -seeds 1 -search 1 hello
tradeoff_plots.sh by script/tradeoff.sh
tsan_tbb.sh by .github/workflows/weekly.yml
uninstall.sh by make/install.mk
update_docs.sh -check
viewer_screens.sh night $work/screens scenes/sphere.scn
wheel.py by script/wheel.sh
wheel.sh by tests/python/test_wheel.py
END

failed=0
fail() { echo "$*"; failed=1; }
try() { "$@" > "$work/log" 2>&1 < /dev/null || fail "$*: $(tail -n 5 "$work/log")"; }

for file in script/*.sh script/*.py script/comp30019; do
  grep -q "^${file#script/} " "$work/table" || fail "the table of tests/scripts.sh lacks $file"
done
while read -r name how words; do
  case " ${*:-$name} " in *" $name "*) ;; *) continue ;; esac
  if echo "$left_out" | grep -qw "$name"; then echo "left out: $name"; continue; fi
  # shellcheck disable=SC2086
  case $how in
    by) grep -q "$name" "$words" || fail "$words does not run $name" ;;
    night) [ -z "${RAYPRO_NIGHT-}" ] || try "script/$name" $words ;;
    *) try "script/$name" "$how" $words ;;
  esac
done < "$work/table"
[ $# = 0 ] || exit $failed

[ -z "${RAYPRO_NIGHT-}" ] || try sh tests/fresh/install.sh "$build"
# A release is refused by each thing that is missing.
if git rev-parse --git-dir > /dev/null 2>&1; then
  git clone -q . "$work/clone"
  echo "maintainer Nobody <nobody@maintainer.invalid>" > "$work/clone/script/release_fields.txt"
  if "$work/clone/script/release.sh" "$work/release" > "$work/log" 2>&1; then fail "release.sh refuses nothing"; fi
  for problem in "uncommitted changes" "not have the tag" "maintainer is not filled in" "has no homepage"; do
    grep -q "$problem" "$work/log" || fail "release.sh does not report: $problem"
  done
  [ ! -e "$work/release/SHA256SUMS" ] || fail "release.sh builds what it refuses"
fi
# Commands of the first column of a table, and the list of the Makefile: targets that make knows, files that can be run.
make -pq BUILD="$build" nothing 2> /dev/null | sed -n 's/^\([a-z][-a-z]*\):.*/\1/p' > "$work/targets" || true
sed -n '/^| command/,/^$/s/^| \(`.*`\) |.*/\1/p' CONTRIBUTING.md script/README.md docs/building.md | tr '`' '\n' |
  grep -E '^(make|script/|tests/|\.ci/)' > "$work/commands"
sed -n 's/^#   \(make [-a-z]*\).*/\1/p' Makefile >> "$work/commands"
[ "$(wc -l < "$work/commands")" -gt 40 ] || fail "no tables of commands"
while read -r program target rest; do
  case $program in
    make) [ -z "$target" ] || grep -qx -e "$target" "$work/targets" || fail "make $target is no target" ;;
    *) [ -x "$program" ] || fail "$program cannot be run" ;;
  esac
done < "$work/commands"
exit $failed
