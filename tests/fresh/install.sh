#!/bin/sh
# make install, what it leaves behind, and make uninstall, in a folder of its own.
#   usage: tests/fresh/install.sh BUILD      (make installcheck)
set -eu
cd "$(dirname "$0")/../.."
build=$1
tree=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
stage="$work/a stage"
share=$stage/opt/ray/share

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
listing() { (cd "$stage" && find . | LC_ALL=C sort); }
try_make() {
  make -s BUILD="$build" DESTDIR="$stage" PREFIX=/opt/ray "$@" >"$work/log" 2>&1 && return
  cat "$work/log" >&2
  fail "make $*"
}

# Folders and files of others, which must outlive us.
( umask 022
  mkdir -p "$share/man/man1" "$share/raypro/scenes" "$share/applications"
  echo mine > "$share/raypro/scenes/mine.scn"
  echo other > "$share/man/man1/other.1" )
listing > "$work/before"

try_make install
try_make install  # over itself
listing > "$work/installed"

programs=
for program in raypro rayimg raygrade rayview; do
  [ ! -x "$build/$program" ] || programs="$programs $program"
done
for program in $programs; do
  for file in bin/$program share/man/man1/$program.1 share/bash-completion/completions/$program; do
    [ -s "$stage/opt/ray/$file" ] || fail "$file is missing"
  done
  bash -n "$share/bash-completion/completions/$program" || fail "bash does not read the completions of $program"
  "$stage/opt/ray/bin/$program" -version >/dev/null || fail "$program does not run"
done
"$stage/opt/ray/bin/comp30019" --help | grep -q aperture-radius || fail "comp30019 does not run"
for file in man/man5/scn.5 man/man7/raypro-farm.7 man/man1/raypro-slurm.1 mime/packages/raypro.xml icons/hicolor/scalable/apps/raypro.svg doc/raypro/README.md doc/raypro/LICENSE doc/raypro/CHANGELOG.md doc/raypro/docs/options.md \
  raypro/scenes/hello.scn raypro/scenes/textures/checker.png raypro/python/first_steps.ipynb raypro/installed.txt; do
  [ -s "$share/$file" ] || fail "share/$file is missing"
done
case "$programs" in *rayview*) [ -s "$share/applications/rayview.desktop" ] || fail "rayview.desktop is missing" ;; esac

# Whatever the umask, everybody may read it.
unreadable=$(cd "$stage/opt/ray" && find . ! -perm -444; find . -type d ! -perm -555; find bin -type f ! -perm -555)
[ -z "$unreadable" ] || fail "not for everybody: $unreadable"

if command -v groff >/dev/null 2>&1; then
  for page in "$share"/man/man1/ray*.1 "$share/man/man5/scn.5" "$share/man/man7/raypro-farm.7"; do
    words=$(groff -I "$share/man" -man -Tutf8 -ww "$page" 2>&1 >/dev/null)
    [ -z "$words" ] || fail "groff on $page: $words"
  done
fi
if command -v update-mime-database >/dev/null 2>&1; then
  cp -R "$share/mime" "$work/mime"
  update-mime-database "$work/mime" 2>"$work/log" || { cat "$work/log" >&2; fail "update-mime-database"; }
  grep -q 'text/x-raypro-scene:\*\.scn' "$work/mime/globs" || fail "no file type for .scn"
fi

# The installed program, from elsewhere, on an installed scene, makes the very bytes that the built one makes here.
"$build/raypro" scenes/hello.scn "$work/built.ppm" -width 64 -height 64 -quiet
(cd / && "$stage/opt/ray/bin/raypro" "$share/raypro/scenes/hello.scn" "$work/installed.ppm" -width 64 -height 64 -quiet)
cmp "$work/built.ppm" "$work/installed.ppm" || fail "the installed program makes another picture"

# The scripts of the installation find its programs.
cp "$share/raypro/scenes/sphere.scn" "$work"  # names of scenes have no blanks there
(cd "$work" && env -u RAYPRO -u RAYIMG PATH="$stage/opt/ray/bin:$PATH" "$stage/opt/ray/bin/raypro-movie" -turntable \
  sphere.scn two.avi -frames 2 -width 16 -height 16) || fail "raypro-movie makes no movie"
[ -s "$work/two.avi" ] || fail "raypro-movie leaves no movie"

# Every link of the installed documents leads to a file.
find "$share/doc/raypro" -name '*.md' > "$work/documents"
while IFS= read -r document; do
  grep -o '](\([^):#]*\)[#)]' "$document" | sed 's/^](//; s/[#)]$//' | grep . | sort -u > "$work/links" || true
  while IFS= read -r link; do
    # The folder of scenes is a link to where it will be.
    at=$(dirname "$document")/$link
    case $(realpath -ms "$at") in */doc/raypro/scenes/*) at=$share/raypro/scenes/${at##*/scenes/} ;; esac
    [ -e "$at" ] || fail "$document links to $link"
  done < "$work/links"
done < "$work/documents"

# raypro.py of the installation finds the program of the installation.
if command -v python3 >/dev/null 2>&1; then
  found=$(cd / && env -u RAYPRO PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$share/raypro/python" python3 -c \
    "import os, raypro; print(raypro.render('$share/raypro/scenes/hello.scn', width=8), os.path.realpath(raypro._find('raypro')))")
  [ "$found" = "<raypro.Image 8 x 256> $(realpath "$stage/opt/ray/bin/raypro")" ] || fail "raypro.py says $found"
fi

try_make uninstall
listing > "$work/after"
diff "$work/before" "$work/after" >&2 || fail "uninstall does not undo install"
[ "$(cat "$share/raypro/scenes/mine.scn")" = mine ] || fail "a file of others was changed"
try_make uninstall  # with nothing there
cd "$tree"
count=$(($(wc -l < "$work/installed") - $(wc -l < "$work/before")))
echo "installed, used and uninstalled:$programs, $count files and folders"
