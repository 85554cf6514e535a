#!/bin/sh
# Does what CONTRIBUTING.md says, in a copy of the tree: its shape is built and rendered.
#   usage: tests/contributing.sh BUILD   (the folder of a finished build, below the root of the tree)
set -eu
cd "$(dirname "$0")/.."
build=$1
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
page=CONTRIBUTING.md

fail() { echo "$page: $*" >&2; exit 1; }

# The fenced block that follows the line with these words.
block_after() {
  awk -v words="$1" '
    !seen && index($0, words) { seen = 1 }
    seen && /^```/ { if (fenced) exit; fenced = 1; next }
    fenced { print }
  ' "$page"
}

# What is built already is not built again: only what knows of shapes.
mkdir -p "$copy/tree/$build"
cp -a Makefile make R1 R2 R3 source grader rayimg page script scenes "$copy/tree"
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
