#!/bin/sh
# Makes two scenes to measure the viewer with, build/bench/view FOLDER/city.scn and FOLDER/million.off: a city at night of
# 5,000 boxes and 148 lamps, and a wavy sheet of a million triangles.
#
#     bench/scenes/large.sh FOLDER
#
# A pseudo-random sequence of our own, so that every awk builds the same city: x' = 16807 x mod 2^31 - 1.
# Source: Park and Miller, Random Number Generators: Good Ones Are Hard to Find (1988).
set -eu
[ $# -eq 1 ] || { echo "large.sh: which folder?" >&2; exit 2; }
out=$1/city
mkdir -p "$out"

cat > "$1/city.scn" <<'SCENE'
# A city at night: houses of boxes, 148 lamps, and cars that leave trails while the shutter is open.
camera  -0.5 2.45 5.9   0.06 -0.15 -1   0 1 0   0.5   0.01 100
background  0.12 0.08 0.14
ambient  0.2 0.2 0.2
material  0 0 0  0.03 0.032 0.037  0.55 0.55 0.57  0 0 0  0 0 0  4000 1 0    # 0 wet street
material  0 0 0  0.16 0.155 0.15  0.08 0.08 0.08  0 0 0  0 0 0  60 1 0      # 1 pavement
box 0  -60 -0.2 -120  60 0 30
box 1  1.75 -0.1 -42  2.5 0.05 6
box 1  -2.5 -0.1 -42  -1.75 0.05 6
include city/houses.scn
include city/lamps.scn
include city/cars.scn
SCENE

awk 'BEGIN {
  n = 708
  print "OFF"; print n * n, 2 * (n - 1) * (n - 1), 0
  for (i = 0; i < n; ++i)
    for (j = 0; j < n; ++j) {
      x = 4 * i / (n - 1) - 2; z = 4 * j / (n - 1) - 2
      printf "%.5f %.5f %.5f\n", x, 0.3 * sin(4 * x) * cos(5 * z) + 0.02 * sin(60 * x) * sin(70 * z), z
    }
  for (i = 0; i < n - 1; ++i)
    for (j = 0; j < n - 1; ++j) {
      a = i * n + j
      print 3, a, a + 1, a + n + 1
      print 3, a, a + n + 1, a + n
    }
}' > "$1/million.off"

awk -v out="$out" '
  function random() { state = (state * 16807) % 2147483647; return state / 2147483647 }
  function min(a, b) { return a < b ? a : b }
  # A facade towards +z at z, from x0 to x1: a window in each bay of each floor, of which some are lit.
  function windows(x0, x1, y0, y1, z, lit,   bays, floors, i, j, w, h, x, y) {
    bays = int((x1 - x0) / 0.34); floors = int((y1 - y0) / 0.42)
    if (bays < 1) return
    w = (x1 - x0) / bays; h = 0.42
    for (j = 0; j < floors; ++j)
      for (i = 0; i < bays; ++i) {
        if (random() > lit) continue
        x = x0 + (i + 0.25) * w; y = y0 + (j + 0.3) * h
        printf "box %d  %.2f %.2f %.2f  %.2f %.2f %.2f\n", 3 + int(4 * random()), x, y, z - 0.01,
          x + 0.5 * w, y + 0.5 * h, z + 0.005 > houses
      }
  }
  # Its windows look to +z and to the avenue at x = 0: the group turns one way into the other.
  function house(x, z, width, depth, height,   wall, up, w, d, h, lit) {
    wall = int(3 * random()); lit = 0.25 + 0.45 * random()
    up = 0; w = width; d = depth; h = height
    while (1) {
      printf "box %d  %.2f %.2f %.2f  %.2f %.2f %.2f\n", wall, x - w / 2, up, z - d / 2,
        x + w / 2, up + h, z + d / 2 > houses
      windows(x - w / 2 + 0.06, x + w / 2 - 0.06, up + (up == 0 ? 0.5 : 0), up + h - 0.1, z + d / 2, lit)
      side = x > 0 ? -1 : 1
      printf "begin -1  0 0 %d %.2f  0 1 0 0  %d 0 0 %.2f  0 0 0 1\n", side, x + side * w / 2, -side, z > houses
      windows(-d / 2 + 0.06, d / 2 - 0.06, up + (up == 0 ? 0.5 : 0), up + h - 0.1, 0, lit)
      print "end" > houses
      up += h
      if (up > 9 || random() < 0.45 || w < 1) break
      w *= 0.55 + 0.3 * random(); d *= 0.55 + 0.3 * random(); h *= 0.3 + 0.4 * random()
    }
    if (height > 5 && random() < 0.5) printf "cylinder 2  %.2f %.2f %.2f  0.02 %.2f\n", x, up + 0.5, z, 1 > houses
  }
  function lamp(x, z, red, green, blue,   over) {
    over = x > 0 ? -0.35 : 0.35
    printf "sphere_light  %.3g %.3g %.3g  %.2f 1.18 %.2f  0.07  0.04 0 1\n", red, green, blue, x + over, z > lamps
    printf "sphere 0  %.2f 1.18 %.2f  0.065  cylinder 1  %.2f 0.62 %.2f  0.02 1.24\n", x + over, z, x, z > lamps
    printf "box 1  %.2f 1.23 %.2f  %.2f 1.26 %.2f\n", min(x, x + over), z - 0.015,
      (x > x + over ? x : x + over), z + 0.015 > lamps
  }
  function car(x, z, way,   lights, tall) {
    lights = way > 0 ? 0 : 1  # those that come show white lights, those that go red ones
    printf "begin -1  1 0 0 %.2f  0 1 0 0  0 0 1 %.2f  0 0 0 1  motion 0 0 %.2f\n", x, z, (way > 0 ? 3.2 : -3.2) > cars
    printf "  sphere %d  -0.13 0.16 %.2f  0.035  sphere %d  0.13 0.16 %.2f  0.035\n", lights, 0.4, lights, 0.4 > cars
    printf "  box 2  -0.19 0.06 -0.4  0.19 0.22 0.38  box 3  -0.16 0.22 -0.28  0.16 0.36 0.16\nend\n" > cars
  }
  BEGIN {
    houses = out "/houses.scn"; lamps = out "/lamps.scn"; cars = out "/cars.scn"; state = 20264
    print "# Houses along an avenue, their windows turned to it and to the viewer." > houses
    print "material  0 0 0  0.20 0.17 0.15  0.02 0.02 0.02  0 0 0  0 0 0  50 1 0" > houses
    print "material  0 0 0  0.13 0.14 0.17  0.05 0.05 0.06  0 0 0  0 0 0  200 1 0" > houses
    print "material  0 0 0  0.24 0.21 0.18  0 0 0  0 0 0  0 0 0  1 1 0" > houses
    print "material  0 0 0  0 0 0  0.04 0.04 0.04  0 0 0  1.10 0.72 0.34  1000 1 0" > houses
    print "material  0 0 0  0 0 0  0.04 0.04 0.04  0 0 0  0.85 0.50 0.20  1000 1 0" > houses
    print "material  0 0 0  0 0 0  0.04 0.04 0.04  0 0 0  0.50 0.62 0.75  1000 1 0" > houses
    print "material  0 0 0  0 0 0  0.04 0.04 0.04  0 0 0  0.42 0.28 0.14  1000 1 0" > houses
    for (row = 0; row < 13; ++row) {
      z = -row * 3.4
      for (side = -1; side <= 1; side += 2)
        for (line = 0; line < 5; ++line) {
          x = side * (3.6 + line * 3.1)
          house(x + 0.2 * random(), z, 1.9 + 0.6 * random(), 2 + 0.5 * random(),
                1.6 + (2 + 0.35 * row) * random() * (1 + 0.4 * line) + (random() < 0.2 ? 4 : 0))
        }
    }
    print "# Lamps along the avenue." > lamps
    print "material  0 0 0  0 0 0  0 0 0  0 0 0  2.2 1.5 0.75  1 1 0" > lamps
    print "material  0 0 0  0.05 0.05 0.05  0.1 0.1 0.1  0 0 0  0 0 0  50 1 0" > lamps
    for (row = 0; row < 26; ++row)
      for (side = -1; side <= 1; side += 2) lamp(side * 1.95, 3.2 - row * 1.7, 1.3, 0.82, 0.36)
    # Cross streets, with lamps of a colder light.
    for (row = 0; row < 12; ++row)
      for (line = 1; line < 5; ++line)
        for (side = -1; side <= 1; side += 2) lamp(side * (2 + line * 3.1), -1.7 - row * 3.4, 0.6, 0.72, 0.84)
    print "# Cars on the avenue: to the right those that go, to the left those that come." > cars
    print "material  0 0 0  0 0 0  0 0 0  0 0 0  3.2 2.9 2.3  1 1 0" > cars
    print "material  0 0 0  0 0 0  0 0 0  0 0 0  3.0 0.16 0.07  1 1 0" > cars
    print "material  0 0 0  0.05 0.05 0.06  0.25 0.25 0.25  0 0 0  0 0 0  600 1 0" > cars
    print "material  0 0 0  0.01 0.01 0.01  0.35 0.35 0.35  0 0 0  0 0 0  2000 1 0" > cars
    for (i = 0; i < 15; ++i) {
      car(0.42 + (i % 2) * 0.62, 2.2 - i * 2.6 - random(), -1)
      car(-0.42 - (i % 2) * 0.62, 1.0 - i * 2.6 - random(), 1)
    }
  }'
