#!/bin/sh
# Writes the option tables of README.md, between their markers, from the programs' own tables.
# With -check it changes nothing and fails if the README is out of date.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
rayimg=${RAYIMG:-$here/build/rayimg}
rayview=${RAYVIEW:-$here/build/rayview}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cp "$here/README.md" "$work/new"
replace() {  # name of the markers, program
  "$2" -help markdown > "$work/table"
  sed "/<!-- $1 -->/q" "$work/new" > "$work/next"
  cat "$work/table" >> "$work/next"
  sed -n "/<!-- end of $1 -->/,\$p" "$work/new" >> "$work/next"
  mv "$work/next" "$work/new"
}
replace options "$raypro"
replace "rayimg options" "$rayimg"
if [ -x "$rayview" ]; then  # not every machine builds it
  replace "rayview options" "$rayview"
fi

if [ "${1:-}" = -check ]; then
  cmp -s "$work/new" "$here/README.md" || { echo "README.md: an option table is out of date; run script/update_readme.sh" >&2; exit 1; }
else
  cat "$work/new" > "$here/README.md"
fi
