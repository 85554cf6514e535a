#!/bin/sh
# Installs what was built; make install calls it. Every file, and every folder created for it, is recorded in
# share/raypro/installed.txt: script/uninstall.sh removes these and nothing else.
#   usage: DESTDIR= bindir= datadir= mandir= docdir= script/install.sh BUILD PROGRAM...
set -eu
cd "$(dirname "$0")/.."
build=$1; shift
. script/install_names.sh

umask 022  # whatever the user's: installed files are for everybody
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
list=$work/list

folder() {
  [ ! -d "$DESTDIR$1/" ] || return 0
  folder "${1%/*}"
  mkdir "$DESTDIR$1"
  echo "folder $1" >> "$list"
}

put() {  # mode, file, to be called
  folder "${3%/*}"
  install -m "$1" "$2" "$DESTDIR$3"
  echo "file $3" >> "$list"
}

put_output() {  # to be called, command...
  name=$1; shift
  "$@" > "$work/output"
  put 644 "$work/output" "$name"
}

[ -z "$DESTDIR" ] || mkdir -p "$DESTDIR"
for program in "$@"; do
  put 755 "$build/$program" "$bindir/$program"
  put_output "$mandir/man1/$program.1" "$build/$program" -man
  put_output "$datadir/bash-completion/completions/$program" "$build/$program" -complete bash
  case "$program" in
    raypro) put_output "$mandir/man5/scn.5" "$build/$program" -man scn ;;
    rayview) put 644 share/applications/rayview.desktop "$datadir/applications/rayview.desktop" ;;
  esac
done
# By this name raypro understands the command line of that course. Nobody else's file of the name is replaced.
if [ -L "$DESTDIR$bindir/comp30019" ] || [ ! -e "$DESTDIR$bindir/comp30019" ]; then
  ln -sf raypro "$DESTDIR$bindir/comp30019"
  echo "file $bindir/comp30019" >> "$list"
  put_output "$mandir/man1/comp30019.1" echo .so man1/raypro.1
fi
for engine in parallel slurm; do
  put 755 "script/farm/$engine.sh" "$bindir/raypro-$engine"
  put_output "$mandir/man1/raypro-$engine.1" echo .so man7/raypro-farm.7
done
put 644 share/man/man7/raypro-farm.7 "$mandir/man7/raypro-farm.7"
put 644 share/mime/packages/raypro.xml "$datadir/mime/packages/raypro.xml"
icon=icons/hicolor/scalable/apps/raypro.svg
put 644 "share/$icon" "$datadir/$icon"
# With the images that they show, and the scenes by a link. What else they link to stays in the sources.
docs="README.md LICENSE CHANGELOG.md CITATION.cff CONTRIBUTING.md $(echo docs/*.* docs/notes/*) art/valley.jpg
  art/library.jpg writeup/pictures/pixel.jpg"
find scenes -type f ! -name '.*' > "$work/known"
for file in $docs; do echo "$file" >> "$work/known"; done
for file in $docs; do
  case $file in
    *.md) put_output "$docdir/$file" awk -v name="$file" -v known="$work/known" -f script/installed_links.awk "$file" ;;
    *) put 644 "$file" "$docdir/$file" ;;
  esac
done
if [ -L "$DESTDIR$docdir/scenes" ] || [ ! -e "$DESTDIR$docdir/scenes" ]; then
  ln -sfn "$datadir/raypro/scenes" "$DESTDIR$docdir/scenes"
  echo "file $docdir/scenes" >> "$list"
fi
for movie in movie session; do
  put 755 "script/$movie.sh" "$bindir/raypro-$movie"
  put 644 "share/man/man1/raypro-$movie.1" "$mandir/man1/raypro-$movie.1"
done
for file in raypro.py first_steps.ipynb; do
  put 644 "share/python/$file" "$datadir/raypro/python/$file"
done
# A loop behind a pipe would not stop the script when it fails.
find scenes share/suites -type f ! -name '.*' > "$work/scenes"
while IFS= read -r file; do
  put 644 "$file" "$datadir/raypro/${file#share/}"
done < "$work/scenes"

# Files and folders of an earlier installation are still ours.
folder "${installed%/*}"
echo "file $installed" >> "$list"
[ ! -f "$DESTDIR$installed" ] || cat "$DESTDIR$installed" >> "$list"
LC_ALL=C sort -u "$list" > "$work/sorted"
install -m 644 "$work/sorted" "$DESTDIR$installed"

echo "installed; for file managers to know .scn files, you or your packager may run:"
echo "  update-mime-database $datadir/mime; update-desktop-database $datadir/applications"
