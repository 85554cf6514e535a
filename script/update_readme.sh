#!/bin/sh
# Writes the option table into README.md, between its two markers, from the program's own table of options.
# With -check it changes nothing and fails when the README is out of date.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$here/build/raypro}
work=$(mktemp)
trap 'rm -f "$work"' EXIT
{
  sed '/<!-- options -->/q' "$here/README.md"
  "$raypro" -help markdown
  sed -n '/<!-- end of options -->/,$p' "$here/README.md"
} > "$work"
if [ "${1:-}" = -check ]; then
  cmp -s "$work" "$here/README.md" || { echo "README.md: the option table is out of date; run script/update_readme.sh" >&2; exit 1; }
else
  cat "$work" > "$here/README.md"
fi
