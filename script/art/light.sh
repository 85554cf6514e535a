#!/bin/sh
# Makes the environments of the images in art/: art/light/*.hdr, latitude-longitude maps of light.
# Rows are of one color but for the lamps: such rows take few bytes in an .hdr, so the maps can be wide and sharp.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
rayimg=${RAYIMG:-$here/build/rayimg}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$here/art/light"

# name, rows, and a function radiance(longitude, latitude) in degrees that sets r, g and b, all below 2^6; 0 0 looks along
# -z, longitude grows to the right.
make_map() {
  awk -v width=$((2 * $2)) -v height="$2" '
    function between(x, low, high, soft,   from, to) {  # 1 inside, 0 outside, a ramp as wide as soft at both ends
      from = (x - low) / soft + 0.5; to = (high - x) / soft + 0.5
      if (to < from) from = to
      return from < 0 ? 0 : from > 1 ? 1 : from
    }
    function mix(a, b, t) { return a + (b - a) * t }
    function lamp(share, red, green, blue) { r = mix(r, red, share); g = mix(g, green, share); b = mix(b, blue, share) }
    function patch(lon0, lon1, lat0, lat1, soft) {
      return between(lon, lon0, lon1, soft) * between(lat, lat0, lat1, soft)
    }
    '"$3"'
    BEGIN {
      most = 65535; printf "P3\n%d %d\n%d\n", width, height, most
      for (y = 0; y < height; ++y) {
        lat = 90 - 180 * (y + 0.5) / height
        for (x = 0; x < width; ++x) {
          lon = 360 * (x + 0.5) / width - 180
          radiance()
          printf "%d %d %d\n", r / 64 * most + 0.5, g / 64 * most + 0.5, b / 64 * most + 0.5
        }
      }
    }' > "$work/map.ppm"
  "$rayimg" convert "$work/map.ppm" "$here/art/light/$1.hdr" -exposure 6
}

# A room in the evening: a wide window of six panes to the left, a warm, faint lamp to the right, and small lights far
# behind what is looked at, which a lens makes discs of.
make_map window 640 '
  function spark(at, up, red, green, blue,   x, y) {
    x = lon - at; y = lat - up
    lamp(between(sqrt(x * x + y * y), -1, 0.74, 0.3), red, green, blue)
  }
  function radiance(   up, pane, i) {
    up = (lat + 90) / 180
    r = mix(0.10, 0.12, up); g = mix(0.065, 0.13, up); b = mix(0.045, 0.17, up)
    if (lat > -2 && lat < 22 && lon > -40 && lon < 40)
      for (i = 0; i < 13; ++i)
        spark(-23 + 3.9 * i + 1.3 * sin(5 * i), 6 + 3.2 * sin(2.1 * i) + 2 * sin(0.7 * i),
          5.2, 2.3 + 0.5 * (i % 3), 0.5 + 0.4 * (i % 4))
    pane = (between(lon, -104, -79, 1) + between(lon, -76, -51, 1)) \
         * (between(lat, 8, 27, 1) + between(lat, 29, 48, 1) + between(lat, 50, 69, 1))
    lamp(pane, 4.6, 5.0, 5.5)
    lamp(patch(60, 100, 15, 50, 12), 2.0, 1.3, 0.7)
  }'

# A studio: gray walls, a large soft box above on the left, a strip on the right, a floor of shade.
make_map studio 512 '
  function radiance(   up) {
    up = between(lat, 0, 200, 60)
    r = mix(0.05, 0.22, up); g = mix(0.055, 0.25, up); b = mix(0.07, 0.32, up)
    lamp(patch(-100, -40, 28, 68, 4), 6.5, 6.0, 5.3)
    lamp(patch(58, 78, -4, 60, 4), 2.6, 3.4, 5.0)
    lamp(between(lon > 0 ? 180 - lon : 180 + lon, -40, 40, 6) * between(lat, 20, 50, 6), 1.6, 1.5, 1.5)
  }'

# A jeweller's room: a large warm lamp above on the left, cold ones on the right and behind the viewer, and a glow behind
# what is looked at. None is bright: what cut glass mixes from them has little noise.
make_map jewels 512 '
  function radiance(   up, glow) {
    up = between(lat, 0, 200, 90); glow = lat > 0 ? exp(-lat / 14) : exp(lat / 3)
    r = mix(0.010, 0.03, up) + 0.10 * glow; g = mix(0.014, 0.06, up) + 0.26 * glow; b = mix(0.03, 0.14, up) + 0.36 * glow
    lamp(patch(-125, -60, 10, 62, 6), 2.6, 2.1, 1.5)
    lamp(patch(62, 88, -2, 62, 4), 1.0, 1.6, 2.4)
    lamp(between(lon > 0 ? 180 - lon : 180 + lon, -35, 35, 6) * patch(-180, 180, 24, 58, 6), 1.8, 1.3, 1.6)
  }'

# For the writeup: a sky with a bright patch, and a tower in each direction by which a reflection can be checked: red in front
# (longitude 0), green to the right, blue behind the viewer, yellow to the left.
make_map ../../writeup/scenes/landmarks 128 '
  function tower(at, red, green, blue,   away) {
    away = lon - at; if (away < -180) away += 360
    lamp(away > -9 && away < 9 && lat > 0 && lat < 24, red, green, blue)
  }
  function radiance(   up) {
    up = lat > 0 ? lat / 90 : 0
    r = mix(0.62, 0.16, up); g = mix(0.72, 0.30, up); b = mix(0.85, 0.68, up)
    if (lat < 0) { r = 0.16; g = 0.13; b = 0.11 }
    tower(0, 0.9, 0.05, 0.03); tower(90, 0.05, 0.6, 0.08); tower(180, 0.06, 0.12, 0.9); tower(-90, 0.95, 0.7, 0.05)
    lamp(patch(-150, -115, 42, 66, 6), 13, 11.8, 10)
  }'
