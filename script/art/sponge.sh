#!/bin/sh
# Makes art/sponge/: Menger's sponge as files that include one another, each twenty times. sponge4.scn stands for
# 160,000 boxes. Of 27 cubes the seven are left out that touch no edge of the whole.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/sponge
mkdir -p "$out"

awk -v out="$out" -v third=0.333333333333333315 '
  BEGIN {
    for (level = 1; level <= 4; ++level) {
      file = out "/sponge" level ".scn"
      print "# Menger'"'"'s sponge in the cube from -1 to 1, divided " (level == 1 ? "once" : level " times") "." > file
      if (level == 1) print "material  0 0 0  0.80 0.74 0.66  0 0 0  0 0 0  0 0 0  1 1 0" > file
      for (x = -1; x <= 1; ++x)
        for (y = -1; y <= 1; ++y)
          for (z = -1; z <= 1; ++z) {
            if ((x == 0) + (y == 0) + (z == 0) >= 2) continue
            if (level == 1)
              printf "box 0  %.9g %.9g %.9g  %.9g %.9g %.9g\n", (2 * x - 1) / 3, (2 * y - 1) / 3, (2 * z - 1) / 3,
                (2 * x + 1) / 3, (2 * y + 1) / 3, (2 * z + 1) / 3 > file
            else
              printf "begin -1  %s 0 0 %.9g  0 %s 0 %.9g  0 0 %s %.9g  0 0 0 1  include sponge%d.scn  end\n",
                third, x * 2 / 3, third, y * 2 / 3, third, z * 2 / 3, level - 1 > file
          }
      close(file)
    }
  }'
