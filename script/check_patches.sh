#!/bin/sh
# Whether every patch of script/price, by which the prices of features and promises are measured, still applies, and
# whether what it changes compiles then.
#   usage: script/check_patches.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"
if ! command -v patch > /dev/null; then
  echo "no patch here, so script/price is not checked"
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
failed=0
fail() {
  echo "$1"
  failed=1
}

# What to compile of a file that has changed. The kernels' parts are no headers of their own.
unit_of() {
  case $1 in
    *-inl.h) echo source/accelerate/wide/Kernels ;;
    *.h) [ ! -e "${1%.h}.cpp" ] || echo "${1%.h}" ;;
    *) echo "${1%.cpp}" ;;
  esac
}

for file in script/price/*.patch; do
  [ -e "$file" ] || continue
  rm -rf "$work/tree"
  mkdir "$work/tree"
  cp -rp Makefile script R1 R2 R3 source grader page "$work/tree"
  patch -d "$work/tree" -p1 --force --silent < "$file" > /dev/null || {
    fail "$file no longer applies: make its change to the sources again and store the difference (diff -U1)"
    continue
  }
  units=$(sed -n 's/^+++ b\///p' "$file" | while read -r changed; do unit_of "$changed"; done | sort -u)
  [ -z "$units" ] || make -s -C "$work/tree" BUILD=build JUMBO=no CPPFLAGS=-DHWY_COMPILE_ONLY_STATIC CXXFLAGS=-fsyntax-only \
    $(for unit in $units; do echo "build/obj/$unit.o"; done) > "$work/log" 2>&1 || {
    fail "$file: what it changes does not compile any more:"
    grep -m 3 error "$work/log" || tail -n 3 "$work/log"
  }
done
exit $failed
