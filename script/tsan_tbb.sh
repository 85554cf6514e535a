#!/bin/sh
# Compiles oneTBB for ThreadSanitizer, into build/tsan/tbb, where make tsan finds it. The installed library does not tell
# the sanitizer which threads have waited for which, and it reports races that are none: 102 in one image of 32x24 pixels
# on two threads, where with this library there is not one.
#
#     script/tsan_tbb.sh FOLDER [BUILD]
#
# FOLDER has oneTBB's sources, of the version that is installed: "apt-get source onetbb" fetches Debian's.
set -eu
[ $# -ge 1 ] && [ -d "$1/src/tbb" ] || { echo "tsan_tbb.sh: name a folder with oneTBB's sources; see the top of $0" >&2; exit 2; }
sources=$1 to=${2:-build}/tsan/tbb
flags='-std=c++17 -O1 -g1 -fPIC -pthread -fsanitize=thread -w'
case $(uname -m) in x86_64) flags="$flags -mwaitpkg" ;; esac
mkdir -p "$to"
for file in "$sources"/src/tbb/*.cpp; do
  # shellcheck disable=SC2086  # words
  ${CXX:-g++} $flags -D__TBB_BUILD -D__TBB_DYNAMIC_LOAD_ENABLED=0 -I "$sources/include" -I "$sources/src" \
    -c "$file" -o "$to/$(basename "$file" .cpp).o"
done
${CXX:-g++} -shared -pthread -fsanitize=thread -Wl,-soname,libtbb.so.12 "$to"/*.o -ldl \
  -Wl,--version-script="$sources/src/tbb/def/lin64-tbb.def" -o "$to/libtbb.so.12"
rm -f "$to"/*.o
echo "$to/libtbb.so.12"
