# Read by the tests of this folder, never run: a folder with a scene, an engine on loopback with keys of its own, and a
# raypro that meets with accidents. All of it is gone when the test ends.
fail() { echo "$*" >&2; for f in "$place"/said* "$place"/*.log; do [ ! -s "$f" ] || tail -n 20 "$f" >&2; done; exit 1; }
skip() { echo "$*" >&2; exit 77; }
needs() { for program in "$@"; do command -v "$program" > /dev/null || skip "there is no $program here"; done; }
: "${RAYPRO:?names the program}"
root=$(cd "$(dirname "$0")/../.." && pwd)
PATH=$PATH:/usr/sbin:/sbin
export LC_ALL=C
place=$(mktemp -d)
user=$(id -un)
stop_engine() {
  for file in "$place"/*.pid; do [ ! -s "$file" ] || kill -9 "$(cat "$file")" 2> /dev/null || true; done
}
trap 'stop_engine; rm -rf "$place"' EXIT
trap 'exit 1' INT TERM

# A port that nobody listens on, from this number on. Tests that run at once begin at different numbers, since two of
# them could find the same one free.
free_port() {
  port=$1
  while (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null; do port=$((port + 1)); done
  echo "$port"
}

cd "$place"
mkdir work accidents
cat > work/in.scn << 'SCENE'
camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100
ambient 0.1 0.1 0.1
material 0.1 0.1 0.1  0.7 0.3 0.2  0.3 0.3 0.3  0 0 0  0 0 0  20 1 0
point_light 9 9 9  2 3 4  1 0 0.1
sphere 0  -1 0 0  0.8
sphere 0  1 0.2 0.5  0.6
include floor.scn
SCENE
echo 'box -1  0 -1.2 0  4 0.2 4' > work/floor.scn
set -- in.scn out.png -width 48 -height 36 -mode path -samples 32
(cd work && "$RAYPRO" "$@" -quiet && mv out.png "$place/expected.png")

# What an accident does to the first attempt at a part whose number names a file in accidents/; always-2 lets no attempt
# at part 2 succeed.
cat > raypro << 'WRAPPER'
#!/bin/sh
real=REAL place=PLACE part=
for word; do case $word in */*[0-9]) part=${word%/*} ;; esac; done
case $part in *[!0-9]*) part= ;; esac
if [ "$part" ] && mv "$place/accidents/$part" "$place/accidents/done-$part" 2> /dev/null; then
  . "$place/accidents/done-$part"
fi
[ ! "$part" ] || [ ! -e "$place/always-$part" ] || exit 1
exec "$real" "$@"
WRAPPER
sed -i "s|REAL|'$RAYPRO'|; s|PLACE|'$place'|" raypro
chmod +x raypro
real=$RAYPRO
export RAYPRO="$place/raypro"
# The render is well on its way when it is killed.
killed='"$real" "$@" -samples 100000 & sleep 0.3; kill -9 $!; wait $!; exit 137'
full_disk='ulimit -f 0; trap "" XFSZ; exec "$real" "$@"'
late_clock='"$real" "$@"; for f in out.png.part-$part-*; do touch -d "1 hour" "$f"; done; exit'
# Another job of this name makes the image and removes the parts, between two looks at what is missing.
overtaken() { printf '%s\n' "\"\$real\" \"\$@\"; \"\$real\" in.scn out.png ${more[*]} -quiet; rm -f out.png.part-*; exit"; }

# A movie that this machine renders alone, to be compared with those of engines.
movie() { (cd work && "$root/script/movie.sh" "$@" -frames 3 -width 24 -height 18) > said 2>&1 || fail "movie.sh: status $?"; }
expect_movie() {  # options of movie.sh that name the engine
  printf '%s\n' 'define x 0' 'include in.scn' 'sphere -1  $x 0.5 1  0.4' > work/moving.scn
  movie -turntable -define x -1 1 moving.scn one.avi
  movie -turntable -define x -1 1 "$@" moving.scn many.avi
  # Frames keep the command that made them, and with it the name of a temporary folder.
  sed -i 's/movie\.......//g' work/one.avi work/many.avi
  cmp -s work/one.avi work/many.avi || fail "the movie of many machines is another one"
  for kind in webp:img2webp mp4:ffmpeg; do
    command -v "${kind#*:}" > /dev/null || continue
    movie -turntable "$@" in.scn "many.${kind%:*}"
    [ -s "work/many.${kind%:*}" ] || fail "there is no movie of that kind: $kind"
  done
  rm -f work/moving.scn work/one.avi work/many.*
}

# Further options of raypro, and the image that they make on one machine.
render_with() { more=("$@"); (cd work && "$real" in.scn out.png "${more[@]}" -quiet && mv out.png "$place/expected.png"); }

expect_image() {
  [ -s work/out.png ] || fail "$1: there is no image"
  cmp -s expected.png work/out.png || fail "$1: the image is another one"
  left=$(cd work && ls | grep -v -x -e in.scn -e floor.scn -e out.png || true)
  [ -z "$left" ] || fail "$1: it left $left"
  for accident in accidents/[0-9]*; do [ ! -e "$accident" ] || fail "$1: $accident did not happen"; done
  rm -f work/out.png accidents/*
}
