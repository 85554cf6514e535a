#!/bin/sh
# Makes art/orrery/: an orrery, a clockwork that moves planets around the sun. Five pairs of gears lead from one shaft,
# which turns once a year, to five tubes around one another, and each tube carries a planet's arm. Teeth, ticks and rings
# are instances of one each.
#
#     script/art/orrery.sh [years]      what has gone by since all the arms were set (default 0)
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
rayimg=${RAYIMG:-$here/build/rayimg}
out=$here/art/orrery
mkdir -p "$out"

if [ $# -eq 0 ]; then  # what does not move
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  printf '0.84 -0.5\n1 -0.5\n\n1 -0.5\n1 0.5\n\n1 0.5\n0.84 0.5\n\n0.84 0.5\n0.84 -0.5\n' |
    awk -v around=72 -v smooth=0 -f "$here/script/art/lathe.awk" > "$out/ring.obj"

  # A tooth for a gear of module 1, its pitch line at the origin, pointing to +x, and as high as 1.
  awk 'BEGIN {
    print "# A tooth of a gear."
    n = split("-1.4 -1.05  0 -0.74  0.6 -0.52  1 -0.32  1 0.32  0.6 0.52  0 0.74  -1.4 1.05", p, " ") / 2
    for (side = -1; side <= 1; side += 2)
      for (i = 1; i <= n; ++i) print "v", p[2 * i - 1], side / 2, -p[2 * i]
    printf "f"; for (i = n; i >= 1; --i) printf " %d", i; print ""
    printf "f"; for (i = 1; i <= n; ++i) printf " %d", n + i; print ""
    for (i = 1; i <= n; ++i) { j = i % n + 1; print "f", i, j, n + j, n + i }
  }' > "$out/tooth.obj"

  for teeth in 7 14 24 25 36 39 47 58 83; do
    awk -v teeth="$teeth" '
      function turned(angle, scale) {
        printf "begin -1  %.6g 0 %.6g %.6g  0 1 0 0  %.6g 0 %.6g %.6g  0 0 0 1  ", scale * cos(angle), scale * sin(angle),
          cos(angle) * (scale < 1), -scale * sin(angle), scale * cos(angle), -sin(angle) * (scale < 1)
      }
      BEGIN {
        pi = atan2(0, -1); module = 2 / teeth; root = 1 - 1.2 * module
        print "# A gear of " teeth " teeth: its pitch circle has radius 1, and it is 1 high."
        print "material  0.02 0.014 0.006  0.16 0.11 0.035  0.62 0.46 0.20  0 0 0  0 0 0  400 1 0"
        if (teeth < 20) printf "cylinder 0  0 0 0  %.6g 1\n", root
        else {
          printf "begin -1  %.6g 0 0 0  0 1 0 0  0 0 %.6g 0  0 0 0 1  mesh 0 ring.obj  end\n", root, root
          print "cylinder 0  0 0 0  0.22 1.1"
          for (k = 0; k < 6; ++k) {
            turned(pi * k / 3, 1)
            printf "box 0  0.2 -0.3 -0.045  %.6g 0.3 0.045  end\n", 0.9 * root
          }
        }
        for (k = 0; k < teeth; ++k) { turned(2 * pi * k / teeth, module); print "mesh 0 tooth.obj  end" }
      }' > "$out/gear$teeth.scn"
  done

  awk 'BEGIN {
    pi = atan2(0, -1)
    print "# Thirty ticks of a dial with radius 1, of which the first is long."
    print "material  0 0 0  0.02 0.02 0.025  0 0 0  0 0 0  0 0 0  1 1 0"
    for (k = 0; k < 30; ++k) {
      a = pi * k / 180
      printf "begin -1  %.6g 0 %.6g 0  0 1 0 0  %.6g 0 %.6g 0  0 0 0 1  box 0  %.6g 0 -0.002  0.985 0.004 0.002  end\n",
        cos(a), sin(a), -sin(a), cos(a), k == 0 ? 0.86 : k % 5 == 0 ? 0.92 : 0.95
    }
  }' > "$out/month.scn"

  awk 'BEGIN {
    pi = atan2(0, -1)
    print "# A dial of twelve months; it lies on y = 0.232."
    for (k = 0; k < 12; ++k) {
      c = cos(k * pi / 6); s = sin(k * pi / 6)
      printf "begin -1  %.6g 0 %.6g 0  0 1 0 0.232  %.6g 0 %.6g 0  0 0 0 1  include month.scn  end\n", 1.7 * c, 1.7 * s,
        -1.7 * s, 1.7 * c
    }
  }' > "$out/dial.scn"

  # Globes: bands of clouds, and seas, lands and ice.
  awk 'BEGIN {
    print "P3\n8 64\n255"
    for (y = 0; y < 64; ++y) {
      t = 0.5 + 0.3 * sin(y * 0.62) + 0.2 * sin(y * 1.31 + 1)
      for (x = 0; x < 8; ++x) printf "%d %d %d\n", 150 + 85 * t, 105 + 100 * t, 70 + 100 * t
    }
  }' > "$work/jupiter.ppm"
  awk 'BEGIN {
    print "P3\n256 128\n255"; pi = atan2(0, -1)
    for (y = 0; y < 128; ++y)
      for (x = 0; x < 256; ++x) {
        u = 2 * pi * x / 256; v = pi * (y / 128 - 0.5)
        a = cos(u) * cos(v) * 3; b = sin(u) * cos(v) * 3; c = sin(v) * 3
        land = sin(a * 1.1 + 2 * sin(b)) + sin(b * 1.3 + 1.7 * sin(c + 1)) + sin(c * 1.2 + 1.5 * sin(a + 2)) \
          + 0.4 * sin(3.1 * a + 2 * c) + 0.3 * sin(4.3 * b - 3.7 * c)
        if (v * v > 1.5) print "235 240 245"
        else if (land > 0.55) print 90 + int(25 * sin(5 * a)), 125, 60
        else print "24 62 130"
      }
  }' > "$work/earth.ppm"
  for name in jupiter earth; do (cd "$work" && "$rayimg" convert $name.ppm $name.jpg -jpeg_quality 85); done
  cp "$work/jupiter.jpg" "$work/earth.jpg" "$out"
fi

awk -v years="${1:-0}" '
  function turned(angle, x, y, z) {
    printf "begin -1  %.8g 0 %.8g %.6g  0 1 0 %.6g  %.8g 0 %.8g %.6g  0 0 0 1\n", cos(angle), sin(angle), x, y,
      -sin(angle), cos(angle), z
  }
  function gear(teeth, x, y, angle, radius) {
    turned(angle, x, y, 0)
    printf "  begin -1  %.6g 0 0 0  0 0.05 0 0  0 0 %.6g 0  0 0 0 1  include gear%d.scn  end\nend\n", radius, radius, teeth
  }
  # A pair of gears and what they move. The shaft goes the other way round than the planets. Its gear has a gap where the
  # other has a tooth.
  function planet(level, driver, driven, start, arm, tube, size, material,   radius, angle, y) {
    radius = apart * driver / (driver + driven); y = 0.42 + 0.15 * level
    gear(driver, apart, y, pi + pi / driver - 2 * pi * years, radius)
    angle = 2 * pi * years * driver / driven
    gear(driven, 0, y, angle, apart - radius)
    top = 1.62 - 0.075 * level
    printf "cylinder 0  0 %.6g 0  %.6g %.6g\n", (y + top) / 2, tube, top - y
    printf "cylinder 0  0 %.6g 0  %.6g 0.05\n", top, tube + 0.03
    turned(start + angle, 0, top, 0)
    printf "  box 0  -0.28 -0.012 -0.022  %.6g 0.012 0.022  sphere 0  -0.28 0 0  0.05\n", arm
    printf "  cylinder 0  %.6g %.6g 0  0.014 %.6g  sphere 0  %.6g 0 0  0.035\n", arm, (plane - top) / 2, plane - top, arm
    if (level == 2 || level == 4) globe(arm, size, material, level)
    else printf "  sphere %d  %.6g %.6g 0  %.6g\n", material, arm, plane - top, size
    print "end"
  }
  function globe(arm, size, material, level,   k, a, d) {  # the poles of a texture are on z
    printf "  begin -1  1 0 0 %.6g  0 0 1 %.6g  0 -1 0 0  0 0 0 1  sphere %d  0 0 0  %.6g  end\n", arm, plane - top,
      material, size
    for (k = 0; k < (level == 2 ? 1 : 4); ++k) {
      a = level == 2 ? 2 * pi * years * 13.37 : k * 2.2 + 2 * pi * years * 8 / (k + 1)
      d = level == 2 ? 0.26 : size + 0.09 + 0.07 * k
      printf "  sphere 8  %.6g %.6g %.6g  %.6g\n", arm + d * cos(a), plane - top, -d * sin(a), level == 2 ? 0.04 : 0.022
    }
    if (level == 2)
      printf "  torus 0  %.6g %.6g 0  0.26 0.007\n", arm, plane - top
  }
  BEGIN {
    pi = atan2(0, -1); apart = 0.78; plane = 2.05
    print "# The moving parts of an orrery, " years " years after its arms were set."
    print "material  0.02 0.014 0.006  0.16 0.11 0.035  0.62 0.46 0.20  0 0 0  0 0 0  400 1 0        # 0 brass"
    print "material  0.01 0.01 0.01  0.10 0.10 0.11  0.50 0.51 0.54  0 0 0  0 0 0  400 1 0           # 1 steel"
    print "material  0.05 0.05 0.05  0.42 0.36 0.30  0.05 0.05 0.05  0 0 0  0 0 0  60 1 0            # 2 Mercury"
    print "material  0.05 0.05 0.05  0.85 0.66 0.36  0.06 0.06 0.06  0 0 0  0 0 0  60 1 0            # 3 Venus"
    print "material  0.08 0.08 0.08  0.95 0.95 0.95  0.06 0.06 0.06  0 0 0  0 0 0  200 1 earth.jpg   # 4 the earth"
    print "material  0.05 0.05 0.05  0.72 0.24 0.10  0.04 0.04 0.04  0 0 0  0 0 0  60 1 0            # 5 Mars"
    print "material  0.08 0.08 0.08  0.95 0.95 0.95  0.04 0.04 0.04  0 0 0  0 0 0  60 1 jupiter.jpg  # 6 Jupiter"
    print "material  0 0 0  0 0 0  0 0 0  0 0 0  1.5 1.1 0.42  1 1 0                                  # 7 the sun"
    print "material  0.05 0.05 0.05  0.75 0.74 0.70  0.04 0.04 0.04  0 0 0  0 0 0  60 1 0            # 8 moons"
    # Periods in years, and what the teeth make of them: 0.2408 (14/58 = 0.2414), 0.6152 (24/39 = 0.6154), 1,
    # 1.8808 (47/25 = 1.88), 11.862 (83/7 = 11.857).
    planet(0, 58, 14, 1.5, 0.66, 0.040, 0.07, 2)
    planet(1, 39, 24, -0.7, 1.02, 0.055, 0.12, 3)
    planet(2, 36, 36, 4.1, 1.45, 0.070, 0.14, 4)
    planet(3, 25, 47, 0.9, 1.95, 0.085, 0.10, 5)
    planet(4, 7, 83, 2.75, 2.55, 0.100, 0.32, 6)
    printf "cylinder 1  0 %.6g 0  0.022 %.6g  sphere 7  0 %.6g 0  0.26\n", plane / 2, plane, plane
    printf "cylinder 1  %.6g 0.68 0  0.035 1  sphere 0  %.6g 1.2 0  0.06\n", apart, apart
  }' > "$out/moving.scn"
