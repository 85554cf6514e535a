#!/bin/sh
# What single precision would cost: raypro once more with script/price/single.patch, which rounds hits, positions, normals,
# ray directions and distances to single precision where they are stored, with error bounds to match, and computes with them
# in double precision as before. Both take the same random numbers. Prints, scene by scene, the error this makes in the
# image, the share of pixels that change by more than 1/255, and of closed rooms how many samples see the outside.
#
#     script/price_of_single.sh
#
# A renderer that computes in single precision too has all of these errors and more. How much time it saves is another
# measurement: script/price_of_contract.sh. BUILD names the build to start from (default build). A table for docs/accuracy.md
# goes to build/price/single.md (OUT names another folder).
set -eu
export LC_ALL=C  # numbers have a point
cd "$(dirname "$0")/.."
build=${BUILD:-build}
out=${OUT:-$build/price}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
make -s BUILD="$build" raypro rayimg > /dev/null
tree=$build/price/single  # kept, so that only what changes is compiled again
rm -rf "$tree/source" "$tree/R1" "$tree/R2" "$tree/R3"
mkdir -p "$tree" "$out"
cp -rp Makefile script R1 R2 R3 source grader page "$tree"
patch -s -d "$tree" -p1 < script/price/single.patch
make -s -C "$tree" BUILD=build raypro > "$work/log" 2>&1 || {
  cat "$work/log" >&2
  exit 1
}
single=$tree/build/raypro

# A globe of radius 1 as a mesh of triangles, around (x, x, x).
globe() {  # x
  awk -v x="$1" 'BEGIN {
    rows = 32; columns = 64; pi = atan2(0, -1)
    print "OFF", (rows + 1) * columns, 2 * (rows - 1) * columns, 0
    for (i = 0; i <= rows; ++i)
      for (j = 0; j < columns; ++j) {
        r = sin(pi * i / rows); angle = 2 * pi * j / columns
        printf "%.17g %.17g %.17g\n", x + r * cos(angle), x + cos(pi * i / rows), x + r * sin(angle)
      }
    for (i = 0; i < rows; ++i)
      for (j = 0; j < columns; ++j) {
        k = i * columns + j; right = i * columns + (j + 1) % columns
        if (i > 0) print 3, k, right, k + columns
        if (i < rows - 1) print 3, right, right + columns, k + columns
      }
  }'
}
# A camera 4 before the globe around (x, x, x), and what it stands on.
globe_scene() {  # x
  globe "$1" > "$work/globe$1.off"
  awk -v x="$1" 'BEGIN {
    print "camera", x, x + 1.2, x + 4, "0 -.3 -1  0 1 0  .4  .01 1000\nambient .3 .3 .3\nbackground .5 .6 .8"
    print "dir_light .8 .8 .7  -1 -1.5 -1"
    print "material .5 .5 .5  .6 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0\nmaterial .5 .2 .1  .7 .3 .2  .2 .2 .2  0 0 0  0 0 0  50 1 0"
    print "quad 0", x - 4, x - 1, x - 4, x - 4, x - 1, x + 4, x + 4, x - 1, x + 4, x + 4, x - 1, x - 4
    print "mesh 1 globe" x ".off"
  }'
}
for x in 0 1000 1000000; do globe_scene "$x" > "$work/globe$x.scn"; done

# A ball of radius 1/1000 on a large floor, from near by.
cat > "$work/grain.scn" <<'END'
camera 0 .002 .008   0 -.15 -1   0 1 0   .4   .0001 100
ambient .3 .3 .3
background .5 .6 .8
dir_light .8 .8 .7   -1 -1.5 -1
material .5 .5 .5  .6 .6 .6  0 0 0     0 0 0  0 0 0  1 1 0
material .5 .2 .1  .7 .3 .2  .2 .2 .2  0 0 0  0 0 0  50 1 0
quad 0   -50 0 -50   -50 0 50   50 0 50   50 0 -50
sphere 1   0 .001 0   .001
END
# A floor of slivers, 1000 times as long as wide, under a ball.
awk 'BEGIN {
  print "camera 0 1.7 6  0 -.2 -1  0 1 0  .4  .01 1000\nambient .3 .3 .3\nbackground .5 .6 .8\ndir_light .8 .8 .7  -1 -1.5 -1"
  print "material .5 .5 .5  .6 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0\nmaterial .5 .2 .1  .7 .3 .2  .2 .2 .2  0 0 0  0 0 0  50 1 0"
  for (i = 0; i < 1000; ++i) {
    x = -5 + .01 * i
    print "tri 0", x, "0 -5", x, "0 5", x + .01, "0 -5\ntri 0", x + .01, "0 -5", x, "0 5", x + .01, "0 5"
  }
  print "sphere 1  0 1 0  1"
}' > "$work/slivers.scn"
# Two sheets in one tilted plane, each of which has a side of its own within the other.
cat > "$work/coplanar.scn" <<'END'
camera 0 .8 6   0 -.1 -1   0 1 0   .4   .01 100
ambient .5 .5 .5
dir_light .8 .8 .7   -1 -1.5 -1
material .5 .5 .5  .6 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0
material .5 .1 .1  .7 .1 .1  0 0 0  0 0 0  0 0 0  1 1 0
begin -1
rotate 33.7 1 0 0
rotate 21.3 0 1 0
quad 0   -2 -2 0   2 -2 0   2 2 0   -2 2 0
tri 1   -1.3 -1.1 0   1.7 -.9 0   .1 1.3 0
end
END

# Rooms without a gap, under a sky that shows through any.
sky=1000000
room() {  # material of the walls, number; the turn in degrees; where it stands
  awk -v wall="$1" -v turn="$2" -v x="$3" -v sky=$sky 'BEGIN {
    print "camera", x, x, x, ".3 -.2 -1  0 1 0  .7  .01 1000\nbackground", sky, sky, sky, "\nambient .3 .3 .3"
    print "material .5 .5 .5  .6 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0\nmaterial 0 0 0  .1 .1 .1  0 0 0  .9 .9 .9  0 0 0  1 1 0"
    print "begin -1\ntranslate", x, x, x, "\nrotate", turn, "0 1 0\nrotate", turn / 3, "1 0 0"
    split("-1 -1 -1 -1 -1 1 1 -1 1 1 -1 -1;-1 1 -1 1 1 -1 1 1 1 -1 1 1;-1 -1 -1 1 -1 -1 1 1 -1 -1 1 -1;" \
          "-1 -1 1 -1 1 1 1 1 1 1 -1 1;-1 -1 -1 -1 1 -1 -1 1 1 -1 -1 1;1 -1 -1 1 -1 1 1 1 1 1 1 -1", sides, ";")
    for (i = 1; i <= 6; ++i) print "quad", wall, sides[i]
    print "end"
  }'
}
room 0 17.3 0 > "$work/room_diffuse.scn"
room 1 17.3 0 > "$work/room_mirrors.scn"
room 0 17.3 1000 > "$work/room_far.scn"
{
  printf 'camera .1 .2 .3   .3 -.2 -1   0 1 0   .7   .01 100\nbackground %s %s %s\nambient .3 .3 .3\n' $sky $sky $sky
  echo 'material .5 .5 .5  .6 .6 .6  0 0 0  0 0 0  0 0 0  1 1 0'
  echo 'mesh 0 globe0.off'
} > "$work/room_globe.scn"

table=$out/single.md
: > "$table"
print_row() { echo "| $1 | $2 | $3 | $4 |" | tee -a "$table"; }
print_row scene "error, of 255" "pixels that change" "paths that leave"
print_row --- --- --- ---
compare() {  # name, whether it is a closed room, scene and options
  name=$1 is_room=$2
  shift 2
  for program in double single; do
    raypro=$build/raypro
    [ $program = double ] || raypro=$single
    "$raypro" "$@" "$work/$program.pfm" -quiet
  done
  "$build/rayimg" diff "$work/single.pfm" "$work/double.pfm" -fail .00392 > "$work/diff" || true
  error=$(sed -n 's/^display RMSE *\([0-9.e+-]*\).*/\1/p' "$work/diff")
  changed=$(sed -n 's/^beyond .* pixels, \([0-9.e+-]*\)%/\1/p' "$work/diff")
  leaks=
  if [ "$is_room" = yes ]; then
    # A sample of the sky is worth at least a thousand of the room.
    "$build/rayimg" diff "$work/single.pfm" "$work/double.pfm" -fail 1000 > "$work/diff" || true
    leaks=$(sed -n 's/^beyond .*  *\([0-9]*\) pixels,.*/\1/p' "$work/diff")
  fi
  print_row "$name" "$(printf %.2g "$error")" "$(printf %.2g "${changed:-0}")%" "${leaks:+$leaks of 262,144}"
}
for scene in hello first room glass refraction torus texture lens indirect many_lights environment gloss; do
  compare "$scene, whitted" no scenes/$scene.scn -width 192 -height 192 -samples 4
  compare "$scene, path" no scenes/$scene.scn -width 192 -height 192 -samples 4 -mode path
done
for x in 0 1000 1000000; do compare "globe at $x" no "$work/globe$x.scn" -width 256 -height 256; done
for scene in grain slivers coplanar; do compare $scene no "$work/$scene.scn" -width 256 -height 256; done
for scene in room_diffuse room_mirrors room_far room_globe; do
  compare "$(echo $scene | tr _ ' ')" yes "$work/$scene.scn" -mode path -width 512 -height 512 -max_depth 16
done
