#!/bin/sh
# Packs raypro and rayimg, as they were built, with the libraries that they need and the scenes, for Linux systems that
# lack those libraries: unpack it anywhere and run bin/raypro. Only glibc is the system's own; which one is printed.
#   usage: script/tarball.sh [BUILD] [FOLDER]      default: build, and the file there; needs patchelf
set -eu
cd "$(dirname "$0")/.."
build=${1:-build}
into=${2:-$build}
command -v patchelf > /dev/null || { echo "tarball.sh: patchelf is not installed" >&2; exit 1; }
for program in raypro rayimg; do
  [ -x "$build/$program" ] || { echo "tarball.sh: no $build/$program; build it: make" >&2; exit 1; }
done
version=$("$build/raypro" -version | sed -n '1s/^raypro \([0-9][0-9.]*\).*/\1/p')
name=raypro-$version-linux-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$into" "$work/$name/bin" "$work/$name/lib"

# Each library as its program finds it, but for those of glibc, which a system has in one version only.
ldd "$build/raypro" "$build/rayimg" | sed -n 's/^[[:space:]]*\(lib[^ ]*\) => \([^ ]*\) .*/\1 \2/p' | LC_ALL=C sort -u |
  grep -v '^lib\(c\|m\|dl\|rt\|pthread\|resolv\)\.so' > "$work/libraries"
mkdir "$work/$name/licenses"
while read -r library path; do
  cp -L "$path" "$work/$name/lib/$library"
  # Whoever passes a library on passes on its license.
  package=$(dpkg -S "*/$(basename "$(readlink -f "$path")")" 2> /dev/null | sed 's/:.*//' | head -n 1) || true
  license=/usr/share/doc/$package/copyright
  if [ -f "$license" ]; then cp "$license" "$work/$name/licenses/$package"
  else echo "tarball.sh: the license of $library is not at hand; add it" >&2; fi
done < "$work/libraries"
for program in raypro rayimg; do
  cp "$build/$program" "$work/$name/bin/"
  strip "$work/$name/bin/$program"
  patchelf --set-rpath '$ORIGIN/../lib' "$work/$name/bin/$program"
done
for library in "$work/$name"/lib/*; do
  chmod 644 "$library"
  patchelf --set-rpath '$ORIGIN' "$library"
done
cp README.md LICENSE CHANGELOG.md "$work/$name/"
cp -R scenes "$work/$name/"

tar -C "$work" --owner=0 --group=0 --sort=name -czf "$into/$name.tar.gz" "$name"
needed=$(cat "$work/$name"/bin/* "$work/$name"/lib/* | grep -ao 'GLIBC_2\.[0-9]*' | sort -u -t . -k 2n | tail -n 1)
echo "$into/$name.tar.gz $(wc -c < "$into/$name.tar.gz") bytes, for $(uname -m) with glibc ${needed#GLIBC_} or later"
