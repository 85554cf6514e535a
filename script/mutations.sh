#!/bin/sh
# Whether the tests would notice: makes random changes of one line each to a copy of the sources, builds, runs the tests
# of that folder, and prints which changes survived. A survivor is either equivalent or asks for a test.
#
#     script/mutations.sh [-count n] [-seed n] [-seconds n] [-tests "files"] [-list]
#
#   -count n     how many changes, default 30; each takes a build of one folder, a link and the tests
#   -seed n      another choice of them, default 1
#   -seconds n   after so long tests are stopped, and the change counts as noticed; default 600
#   -tests       which tests, default those of R3, every, accelerate, integrate, closed_form and of whole scenes
#   -list        only prints the changes
# CXX and CXXFLAGS are passed on, so that CXX="ccache g++" works.
set -eu
export LC_ALL=C
cd "$(dirname "$0")/.."
count=30 seed=1 seconds=600 list=
tests="tests/R3/*.cpp tests/every/*.cpp tests/source/accelerate/*.cpp tests/source/integrate/*.cpp \
       tests/source/integrate/*/*.cpp tests/agree/Accelerators.cpp tests/agree/ExactScenes.cpp tests/agree/Packets.cpp \
       tests/closed_form/*.cpp tests/extremes/random_scenes.cpp tests/extremes/furnace.cpp tests/extremes/known_radiance.cpp \
       tests/source/app/Program.cpp"
while [ $# -gt 0 ]; do
  case $1 in
    -count | -seed | -seconds | -tests)
      [ $# -gt 1 ] || { echo "$1 takes a value" >&2; exit 2; }
      eval "${1#-}=\$2"
      shift 2 ;;
    -list) list=yes; shift ;;
    *) echo "unknown option $1; see the head of $0" >&2; exit 2 ;;
  esac
done

# Every change that could be made, one a line: file, line, what is found, what takes its place, in tabs.
candidates() {
  find R3 source/accelerate source/integrate -name '*.cpp' | sort | xargs awk '
    BEGIN {
      kinds = split(" < , <= , > , >= , + , - , * , / , == , != , && , || , 1 , 2 ,std::min(,std::max(,true,false,0.5,++", from, ",")
      split(" <= , < , >= , > , - , + , / , * , != , == , || , && , 2 , 1 ,std::max(,std::min(,false,true,0.25,--", to, ",")
    }
    /^[ \t]*(\/\/|#|\/\*)/ || /assert\(|static_assert|template|operator|std::string|throw / { next }
    {
      code = $0
      sub(/\/\/.*/, "", code)
      gsub(/"[^"]*"/, "", code)
      for (k = 1; k <= kinds; ++k)
        if (index(code, from[k])) printf "%s\t%d\t%s\t%s\n", FILENAME, FNR, from[k], to[k]
    }'
}
chosen() {
  candidates | awk -v seed="$seed" -v count="$count" '
    BEGIN { srand(seed) }
    { line[NR] = $0 }
    END {
      for (i = 1; i <= count && i <= NR; ++i) {
        j = i + int(rand() * (NR - i + 1))
        swap = line[i]; line[i] = line[j]; line[j] = swap
        print line[i]
      }
    }'
}
if [ "$list" ]; then chosen; exit; fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
tree=$work/tree
mkdir -p "$tree"
cp -a Makefile make R1 R2 R3 source grader rayimg page tests script scenes writeup docs README.md "$tree"
build() {  # quietly; what it says is kept
  make -C "$tree" CXX="${CXX:-g++}" CXXFLAGS="${CXXFLAGS:-}" CONTEXTS= test-binary TEST_SOURCES="$(cd "$tree" && echo tests/Main.cpp $tests)" \
    < /dev/null > "$work/build.txt" 2>&1
}
run_tests() {
  (cd "$tree" && RAYPRO_ROOT="$tree" timeout "$seconds" build/raytests --gtest_brief=1 --gtest_fail_fast) < /dev/null > "$work/tests.txt" 2>&1
}
build || { tail -20 "$work/build.txt"; exit 1; }
run_tests || { echo "the tests fail without a change:"; tail -20 "$work/tests.txt"; exit 1; }

chosen > "$work/chosen"
survivors=0 noticed=0 refused=0
while IFS="$(printf '\t')" read -r file line found replacement; do
  awk -v line="$line" -v found="$found" -v replacement="$replacement" '
    NR == line { at = index($0, found); $0 = substr($0, 1, at - 1) replacement substr($0, at + length(found)) }
    { print }' "$file" > "$tree/$file"
  what="$file:$line: \"$found\" to \"$replacement\""
  if ! build; then
    refused=$((refused + 1))
    echo "does not compile: $what"
  elif run_tests; then
    survivors=$((survivors + 1))
    echo "SURVIVED: $what"
    sed -n "${line}p" "$file"
  else
    noticed=$((noticed + 1))
    echo "noticed: $what ($(sed -n 's/^\[  FAILED  \] \([^ ]*\).*/\1/p' "$work/tests.txt" | head -1))"
  fi
  cp -p "$file" "$tree/$file"
  touch "$tree/$file"
done < "$work/chosen"
echo "$noticed noticed, $survivors survived, $refused do not compile; seed $seed"
