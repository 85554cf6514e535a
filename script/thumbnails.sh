#!/bin/sh
# Renders every scene of scenes/ into scenes/thumbnails/NAME.jpg and writes scenes/README.md, a table of names, images
# and the scenes' first comments. An image is rendered again only if its scene, a mesh or a texture is newer.
#
#     script/thumbnails.sh [-all | -check]
#
# -all renders all of them. -check changes nothing and fails if the table is out of date or an image is missing.
# RAYPRO names the program. Options of raypro that a scene needs are read from that comment: the words
# after "Seen with", up to a period, a comma or a semicolon.
set -eu
cd "$(dirname "$0")/.."
raypro=${RAYPRO:-build/raypro}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The comment at the start of a file: all lines up to the first that is not one.
comment() { sed -n '/^#/!q; s/^# *//p' "$1" | tr '\n' ' ' | sed 's/ *$//'; }
options() { comment "$1" | sed -n "s/.*Seen with -/-/p" | sed "s/[;,].*//; s/[.] .*//; s/[.]\$//"; }

render() {  # scene, image
  # shellcheck disable=SC2046  # the options are words
  "$raypro" "$1" "$2" -width 128 -height 128 -samples "${SAMPLES:-64}" -filter mitchell -jpeg_quality 80 -quiet \
    $(options "$1")
}

mkdir -p scenes/thumbnails
{
  echo "<!-- Written by script/thumbnails.sh from the first comment of each scene. -->"
  echo "# Scenes, one feature per file"
  echo
  echo "| scene | image | what it shows |"
  echo "|---|---|---|"
  for scene in scenes/*.scn; do
    name=$(basename "$scene" .scn)
    echo "| [$name]($name.scn) | ![$name](thumbnails/$name.jpg) | $(comment "$scene" | sed 's/|/\\|/g') |"
  done
  echo
  echo "Scenes in the languages of other courses, \`*.yaml\`, \`*.yml\`, \`*.json\` and \`comp30019/*.txt\`, are shown in"
  echo "[writeup/courses.html](../writeup/courses.html)."
} > "$work/README.md"

if [ "${1:-}" = -check ]; then
  cmp -s "$work/README.md" scenes/README.md ||
    { echo "scenes/README.md is out of date; run script/thumbnails.sh" >&2; exit 1; }
  for scene in scenes/*.scn; do
    name=$(basename "$scene" .scn)
    [ -f "scenes/thumbnails/$name.jpg" ] || { echo "scenes/thumbnails/$name.jpg is missing" >&2; exit 1; }
  done
  exit 0
fi
for scene in scenes/*.scn; do
  image=scenes/thumbnails/$(basename "$scene" .scn).jpg
  if [ "${1:-}" = -all ] || [ ! -f "$image" ] || [ "$scene" -nt "$image" ] ||
     [ "$(find scenes/meshes scenes/textures -newer "$image" -type f | head -1)" ]; then
    echo "$image"
    render "$scene" "$image"
  fi
done
cp "$work/README.md" scenes/README.md
