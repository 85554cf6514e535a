#!/bin/sh
# Checks that make dist gives the same bytes in different folders, with different umasks and time zones and at different
# times, and that the archive builds without git. It builds without optimization, since it renders next to nothing.
#   usage: script/check_dist.sh [-pack]      -pack: compare the archives only, build nothing
set -eu
cd "$(dirname "$0")/.."
tree=$(pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
pack() {  # folder, umask, time zone
  git clone -q "$tree" "$work/$1"
  (cd "$work/$1" && umask "$2" && TZ=$3 make -s dist >/dev/null)
}
pack one 022 UTC
sleep 1
pack "another one" 077 Asia/Tokyo
archive=$(cd "$work/one/build" && echo raypro-*.tar.gz)
cmp "$work/one/build/$archive" "$work/another one/build/$archive" || fail "two runs differ"
echo "$archive: identical twice, $(wc -c < "$work/one/build/$archive") bytes"
[ "${1-}" != -pack ] || exit 0

mkdir "$work/unpacked" "$work/bin"
tar -xzf "$work/one/build/$archive" -C "$work/unpacked"
cd "$work/unpacked/${archive%.tar.gz}"
version=${archive#raypro-}
grep -qx "version: ${version%.tar.gz}" CITATION.cff || fail "CITATION.cff has another version than the Makefile"
[ ! -e .git ] || fail "the archive holds a checkout"
printf '#!/bin/sh\necho "git was called" >&2\nexit 1\n' > "$work/bin/git"
chmod +x "$work/bin/git"
PATH=$work/bin:$PATH make -s -j"$(getconf _NPROCESSORS_ONLN)" OPTIMIZE="${OPTIMIZE--O0}" \
  CXXFLAGS="${CXXFLAGS-} -Werror" raypro rayimg >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; fail "the unpacked archive does not build"; }
! grep -q 'git was called' "$work/log" || fail "the build calls git"
build/raypro scenes/hello.scn "$work/hello.ppm" -width 32 -height 32 -quiet
build/rayimg info "$work/hello.ppm" >/dev/null
echo "the unpacked archive builds without git and renders"
