#!/bin/sh
# Makes art/stairs/stairs.scn: a spiral staircase of steps, posts and a rail of short cylinders, around a column.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/stairs
mkdir -p "$out"

awk '
  BEGIN {
    pi = atan2(0, -1); steps = 22; rise = 0.34; turn = 2 * pi / 15; reach = 2.3
    print "# A spiral staircase of " steps " steps about the y axis; it stands on y = 0."
    print "material  0 0 0  0.62 0.60 0.56  0 0 0  0 0 0  0 0 0  1 1 0                    # 0 stone"
    print "material  0 0 0  0.42 0.22 0.10  0.06 0.06 0.06  0 0 0  0 0 0  300 1 0          # 1 oak"
    print "material  0 0 0  0.05 0.04 0.02  0.75 0.58 0.28  0 0 0  0 0 0  500 1 0          # 2 brass"
    printf "cylinder 0  0 %.6g 0  0.34 %.6g\n", steps * rise / 2 + 0.6, steps * rise + 1.2
    for (k = 0; k < steps; ++k) {
      a = k * turn; y = (k + 1) * rise
      printf "begin -1  %.6g 0 %.6g 0  0 1 0 %.6g  %.6g 0 %.6g 0  0 0 0 1\n", cos(a), sin(a), y, -sin(a), cos(a)
      printf "  box 1  0.2 -0.09 -0.44  %.6g 0 0.44\n", reach
      printf "  cylinder 2  %.6g 0.5 0  0.022 1\n", reach - 0.1
      # The rail goes from post to post: along the turn and up by a rise.
      x0 = reach - 0.1; x1 = x0 * cos(turn); z1 = -x0 * sin(turn)
      dx = x1 - x0; dz = z1; along = sqrt(dx * dx + dz * dz + rise * rise)
      if (k < steps - 1) {
        ux = dx / along; uy = rise / along; uz = dz / along
        flat = sqrt(ux * ux + uz * uz)
        printf "  begin 2  %.6g %.6g %.6g %.6g  0 %.6g %.6g %.6g  %.6g %.6g %.6g %.6g  0 0 0 1  ",
          -uz / flat, ux, -ux * uy / flat, (x0 + x1) / 2, uy, flat, 1 + rise / 2, ux / flat, uz, -uy * uz / flat, z1 / 2
        printf "cylinder -1  0 0 0  0.05 %.6g  end\n", along
      }
      printf "  sphere 2  %.6g 1 0  0.05\nend\n", x0
    }
  }' > "$out/stairs.scn"

# Tiles of two kinds, a unit wide, with a joint between.
awk '
  BEGIN {
    print "# A floor of tiles, light and dark, from -5 to 5 and from -5 to 10; its top is y = 0."
    print "material  0 0 0  0.40 0.38 0.35  0.12 0.12 0.12  0 0 0  0 0 0  600 1 0   # 0 light"
    print "material  0 0 0  0.05 0.05 0.055  0.14 0.14 0.14  0 0 0  0 0 0  600 1 0   # 1 dark"
    print "material  0 0 0  0.10 0.09 0.08  0 0 0  0 0 0  0 0 0  1 1 0              # 2 joint"
    print "box 2  -5 -0.2 -5  5 -0.01 10"
    for (x = -5; x < 5; ++x)
      for (z = -5; z < 10; ++z)
        printf "box %d  %.6g -0.1 %.6g  %.6g 0 %.6g\n", (x + z + 10) % 2, x + 0.01, z + 0.01, x + 0.99, z + 0.99
  }' > "$out/floor.scn"
