#!/bin/sh
# Writes what README.md and docs/ repeat, between its markers: the tables of options, from the programs' own, and the
# README's scene; and renders two scenes to images of docs/ if they are newer.
# With -check it changes nothing and fails if a text is out of date. The image is not checked: its bytes depend on libjpeg.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
rayimg=${RAYIMG:-$here/build/rayimg}
raygrade=${RAYGRADE:-$here/build/raygrade}
rayview=${RAYVIEW:-$here/build/rayview}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

replace() {  # file, name of the markers; the new text is read
  {
    sed "/<!-- $2 -->/q" "$1"
    cat
    sed -n "/<!-- end of $2 -->/,\$p" "$1"
  } > "$work/next"
  mv "$work/next" "$1"
}
fenced() { echo '```'; cat "$1"; echo '```'; }

cp "$here/README.md" "$here/docs/options.md" "$here/docs/viewer.md" "$work/"
"$raypro" -help markdown | replace "$work/options.md" options
"$rayimg" -help markdown | replace "$work/options.md" "rayimg options"
"$raygrade" -help markdown | replace "$work/options.md" "raygrade options"
if [ -x "$rayview" ]; then  # not every machine builds it
  "$rayview" -help markdown | replace "$work/options.md" "rayview options"
  "$rayview" -list keys > "$work/keys"
  fenced "$work/keys" | replace "$work/viewer.md" "rayview keys"
fi
fenced "$here/scenes/first.scn" | replace "$work/README.md" "scenes\/first.scn"

update() {  # file of the tree, new
  cmp -s "$2" "$here/$1" && return
  if [ "$check" ]; then echo "$1 is out of date; run script/update_docs.sh" >&2; exit 1; fi
  cat "$2" > "$here/$1"
}
check=
[ "${1:-}" != -check ] || check=yes
update README.md "$work/README.md"
update docs/options.md "$work/options.md"
update docs/viewer.md "$work/viewer.md"
# Images keep their command, which is to be one for any checkout.
picture() {  # scene, image
  [ "$check" ] || [ "$here/$2" -nt "$here/$1" ] ||
    (cd "$here" && "$raypro" "$1" "$2" -width 480 -height 320 -samples 64 -filter mitchell -quiet)
}
picture scenes/first.scn docs/first.jpg
picture scenes/texture_directions.scn docs/directions.jpg
