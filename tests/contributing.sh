#!/bin/sh
# Does what CONTRIBUTING.md says, in a copy of the tree: its shape is built and rendered, and every command of its table
# and those of script/README.md is there to be run.
#   usage: tests/contributing.sh BUILD   (the folder of a finished build, below the root of the tree)
set -eu
cd "$(dirname "$0")/.."
build=$1
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
page=CONTRIBUTING.md
others=script/README.md

fail() { echo "$page: $*" >&2; exit 1; }

# The fenced block that follows the line with these words.
block_after() {
  awk -v words="$1" '
    !seen && index($0, words) { seen = 1 }
    seen && /^```/ { if (fenced) exit; fenced = 1; next }
    fenced { print }
  ' "$page"
}

# Commands of the first column: targets that make knows, scripts that can be run.
sed -n '/^| command/,/^$/s/^| \(`.*`\) |.*/\1/p' "$page" "$others" | tr '`' '\n' | grep -E '^(make|script/|tests/|\.ci/)' > "$copy/commands"
[ -s "$copy/commands" ] || fail "no table of commands"
while read -r program rest; do
  case $program in
    # Fuzzing takes clang, which may be missing; the target is there all the same.
    make) make -n BUILD="$build" FUZZ_CXX="${CXX:-g++}" ${rest%% *} > /dev/null 2>&1 || fail "make $rest cannot be made" ;;
    *) [ -x "$program" ] || fail "$program cannot be run" ;;
  esac
done < "$copy/commands"

# What is built already is not built again: only what knows of shapes.
mkdir -p "$copy/tree/$build"
cp -a Makefile make R1 R2 R3 source grader page script scenes "$copy/tree"
cp -a "$build/obj" "$build/jumbo" "$build/flags" "$build/features" "$copy/tree/$build"
block_after '`R3/shapes/ring.cpp`:' > "$copy/tree/R3/shapes/ring.cpp"
sed -n 's/^    \(SHAPE(.*)\)$/\1/p' "$page" >> "$copy/tree/R3/shapes.def"
block_after '`ring.scn`' > "$copy/tree/ring.scn"
cd "$copy/tree"
grep -q 'class Ring' R3/shapes/ring.cpp && grep -q 'SHAPE(ring)' R3/shapes.def || fail "the ring is not where it was"
# Without optimization, which takes most of the time and changes no byte.
make -s BUILD="$build" OPTIMIZE_HERE=-O0 raypro > "$copy/log" 2>&1 || { cat "$copy/log" >&2; fail "the ring does not compile"; }
"$build/raypro" ring.scn ring.ppm -width 32 -height 24 -quiet || fail "the ring's scene does not render"
sed '/^ring/d' ring.scn > none.scn
"$build/raypro" none.scn none.ppm -width 32 -height 24 -quiet
! cmp -s ring.ppm none.ppm || fail "the ring is not seen"
echo "CONTRIBUTING.md does what it says"
