#!/bin/sh
# Removes the files that script/install.sh installed, then the folders that it created if they are empty. make uninstall
# calls it.
#   usage: DESTDIR= bindir= datadir= mandir= docdir= script/uninstall.sh
set -eu
cd "$(dirname "$0")/.."
. script/install_names.sh

if [ ! -f "$DESTDIR$installed" ]; then
  echo "nothing to uninstall: $DESTDIR$installed does not exist"
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
LC_ALL=C sort -r "$DESTDIR$installed" > "$work/list"  # what is in a folder stands before it
while read -r kind name; do
  [ "$kind" != file ] || rm -f "$DESTDIR$name"
done < "$work/list"
while read -r kind name; do
  [ "$kind" != folder ] || rmdir "$DESTDIR$name" 2>/dev/null || true  # others may have put files there
done < "$work/list"
