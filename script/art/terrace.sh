#!/bin/sh
# Makes what art/terrace.scn includes: a tiled floor, a wall of arches, a parasol of Bezier patches, chairs, potted trees,
# lemons and glass. Lengths are in meters.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/terrace
mkdir -p "$out"

# Each file has materials of its own: here all of them, the same in every file.
part() { { materials; cat; } > "$out/$1.scn"; }
materials() {
  cat << END
material 0 0 0  0.34 0.15 0.085   0.03 0.03 0.03  0 0 0  0 0 0  20 1 0     # 0 clay tiles
material 0 0 0  0.37 0.17 0.1   0.03 0.03 0.03  0 0 0  0 0 0  20 1 0     # 1
material 0 0 0  0.3 0.13 0.075  0.03 0.03 0.03  0 0 0  0 0 0  20 1 0     # 2
material 0 0 0  0.58 0.54 0.46  0 0 0  0 0 0  0 0 0  1 1 0               # 3 limestone
material 0 0 0  0.66 0.64 0.58  0 0 0  0 0 0  0 0 0  1 1 0               # 4 whitewash
material 0 0 0  0.07 0.2 0.38   0.04 0.04 0.04  0 0 0  0 0 0  40 1 0     # 5 blue paint
material 0 0 0  0.72 0.69 0.62  0 0 0  0 0 0  0 0 0  1 1 0               # 6 cloth
material 0 0 0  0.62 0.33 0.1   0 0 0  0 0 0  0 0 0  1 1 0               # 7 cloth
material 0 0 0  0.02 0.025 0.03 0.06 0.06 0.06  0 0 0  0 0 0  4000 1 0   # 8 panes of a dark room
material 0 0 0  0.04 0.05 0.045 0.06 0.06 0.06  0 0 0  0 0 0  60 1 0     # 9 iron
material 0 0 0  0.42 0.25 0.13  0.03 0.03 0.03  0 0 0  0 0 0  30 1 0     # 10 wood
material 0 0 0  0.1 0.2 0.04    0.03 0.03 0.03  0 0 0  0 0 0  30 1 0     # 11 leaves
material 0 0 0  0.16 0.27 0.06  0.03 0.03 0.03  0 0 0  0 0 0  30 1 0     # 12
material 0 0 0  0.8 0.6 0.03    0.03 0.03 0.03  0 0 0  0 0 0  40 1 0     # 13 lemons
material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 1.5 0                      # 14 glass
material 0 0 0  0 0 0  0 0 0  1 1 1  0 0 0  1 1.33 0                     # 15 lemonade
absorb 15  0.4 1.2 9
priority 14 1
material 0 0 0  0.02 0.09 0.14  0.25 0.27 0.28  0 0 0  0 0 0  120 1 0    # 16 sea
material 0 0 0  0.22 0.3 0.36   0 0 0  0 0 0  0 0 0  1 1 0               # 17 islands, in haze
material 0 0 0  0.4 0.38 0.34   0 0 0  0 0 0  0 0 0  1 1 0               # 18 joints
material 0 0 0  0.55 0.62 0.66  0.08 0.08 0.08  0 0 0  0 0 0  200 1 0    # 19 glazed bowl
material 0 0 0  0.47 0.22 0.12  0 0 0  0 0 0  0 0 0  1 1 0               # 20 pots
material 0 0 0  0.05 0.035 0.02 0 0 0  0 0 0  0 0 0  1 1 0               # 21 soil
END
}

# Clay tiles of 30 cm with joints of 6 mm, three colors at random.
tiles() { awk 'BEGIN {
  srand(5)
  for (i = -14; i < 14; ++i)
    for (k = -10; k < 16; ++k)
      printf "box %d  %.3f -0.03 %.3f  %.3f %.4f %.3f\n", int(3 * rand()), 0.3 * i, 0.3 * k, 0.3 * i + 0.294,
        0.0015 * rand(), 0.3 * k + 0.294
}'; }

# A wall of 95 cm with nine arches, cut out of it.
wall() { awk 'BEGIN {
  print "csg difference 3\n  box 3  -4.2 0 -3.16  4.2 0.85 -2.98\n  csg union 3"
  for (x = -3.9; x < 4.2; x += 0.65) {
    printf "    box 3  %.3f 0.18 -3.3  %.3f 0.48 -2.8\n", x - 0.2, x + 0.2
    printf "    begin 3 translate %.3f 0.48 -3.05 rotate 90 1 0 0  cylinder 3  0 0 0  0.2 0.6  end\n", x
  }
  print "  end\nend"
  print "box 3  -4.2 0.85 -3.22  4.2 0.91 -2.92"
}'; }

# The house: a wall with a window in it, and blue shutters of slats, open.
awk 'BEGIN {
  print "csg difference 4\n  box 4  -3.5 0 -3  -3.2 4 5\n  box 4  -3.6 0.95 -0.7  -3.1 2.25 0.3\nend"
  print "box 8  -3.42 0.95 -0.7  -3.4 2.25 0.3"                                  # a dark room
  print "box 3  -3.36 0.89 -0.8  -3.12 0.95 0.4"                                  # sill
  print "box 4  -3.4 0.95 -0.22  -3.36 2.25 -0.18\nbox 4  -3.4 1.58 -0.7  -3.36 1.62 0.3"   # bars
  for (side = 0; side < 2; ++side) {
    z = side ? 0.34 : -1.24
    printf "box 5  -3.2 0.95 %.3f  -3.15 2.25 %.3f\nbox 5  -3.2 0.95 %.3f  -3.15 2.25 %.3f\n", z, z + 0.05, z + 0.45, z + 0.5
    printf "box 5  -3.2 0.95 %.3f  -3.15 1.02 %.3f\nbox 5  -3.2 2.18 %.3f  -3.15 2.25 %.3f\n", z, z + 0.5, z, z + 0.5
    for (y = 1.04; y < 2.17; y += 0.045)
      printf "begin 5 translate -3.17 %.3f %.3f rotate 35 0 0 1  box 5  -0.022 -0.004 0  0.022 0.004 0.4  end\n", y, z + 0.05
  }
}' | part house

# A parasol: eight gores, each a patch that sags between its ribs; a pole and a foot.
awk 'BEGIN {
  pi = atan2(0, -1)
  for (g = 0; g < 8; ++g) {
    low = 2 * pi * g / 8; high = 2 * pi * (g + 1) / 8
    printf "bezier %d", g % 2 ? 6 : 7
    for (v = 0; v < 4; ++v) {
      r = 1.25 * (1 - v / 3); y = 2.12 + 0.42 * v / 3 + (v == 1 ? 0.05 : v == 2 ? 0.07 : 0)
      for (u = 0; u < 4; ++u) {
        a = high + (low - high) * u / 3
        inner = u == 1 || u == 2
        s = inner ? 0.96 : 1; sag = inner ? -0.07 * (1 - v / 3) : 0
        printf "  %.4f %.4f %.4f", r * s * cos(a), y + sag, r * s * sin(a)
      }
    }
    print ""
  }
  print "cylinder 9  0 1.3 0  0.022 2.6\nsphere 9  0 2.62 0  0.035\ncylinder 3  0 0.05 0  0.24 0.1\ncylinder 3  0 0.2 0  0.04 0.2"
}' | part parasol

# A bistro chair of iron rods with wooden slats; it faces +z, and its seat is 45 cm high.
awk '
function rod(x, y, z, X, Y, Z, r,   l, tilt, turn) {  # a cylinder from here to there
  l = sqrt((X - x) ^ 2 + (Y - y) ^ 2 + (Z - z) ^ 2)
  tilt = atan2(sqrt((X - x) ^ 2 + (Z - z) ^ 2), Y - y) * 180 / pi; turn = atan2(X - x, Z - z) * 180 / pi
  printf "begin 9 translate %.4f %.4f %.4f rotate %.3f 0 1 0 rotate %.3f 1 0 0  cylinder 9  0 0 0  %.4f %.4f  end\n",
    (x + X) / 2, (y + Y) / 2, (z + Z) / 2, turn, tilt, r, l
}
BEGIN {
  pi = atan2(0, -1)
  for (s = -1; s <= 1; s += 2) {
    rod(s * 0.19, 0, 0.22, s * 0.19, 0.86, -0.24, 0.011)   # front foot to back
    rod(s * 0.17, 0, -0.24, s * 0.17, 0.45, 0.2, 0.011)
    rod(s * 0.18, 0.44, -0.19, s * 0.18, 0.44, 0.21, 0.009)
  }
  rod(-0.19, 0.1, 0.165, 0.19, 0.1, 0.165, 0.008)
  rod(-0.17, 0.1, -0.14, 0.17, 0.1, -0.14, 0.008)
  for (i = 0; i < 6; ++i) printf "box 10  -0.21 0.45 %.3f  0.21 0.466 %.3f\n", -0.19 + 0.068 * i, -0.19 + 0.068 * i + 0.056
  for (i = 0; i < 3; ++i)
    printf "begin 10 translate 0 %.3f %.3f rotate -28 1 0 0  box 10  -0.21 -0.025 -0.006  0.21 0.025 0.006  end\n",
      0.66 + 0.075 * i, -0.125 - 0.04 * i
}' | part chair

# A little tree in a pot: leaves on a ball, each two triangles.
leaves() {
  awk -v count="$1" -v seed="$2" 'BEGIN {
    srand(seed); pi = atan2(0, -1)
    for (i = 0; i < count; ++i) {
      y = 2 * rand() - 1; a = 2 * pi * rand(); s = sqrt(1 - y * y); r = 0.26 + 0.1 * rand() ^ 2
      px = r * s * cos(a); py = r * y; pz = r * s * sin(a)
      b = 2 * pi * rand(); t = 0.6 * (rand() - 0.5)
      dx = cos(b); dy = t; dz = sin(b)              # along the leaf
      nx = s * cos(a) + 0.9 * (rand() - 0.5); ny = y + 0.9 * (rand() - 0.5); nz = s * sin(a) + 0.9 * (rand() - 0.5)
      wx = dy * nz - dz * ny; wy = dz * nx - dx * nz; wz = dx * ny - dy * nx
      l = 0.028 + 0.014 * rand(); w = 0.3 * l / sqrt(wx * wx + wy * wy + wz * wz + 1e-9)
      printf "quad %d  %.4f %.4f %.4f  %.4f %.4f %.4f  %.4f %.4f %.4f  %.4f %.4f %.4f\n", 11 + (rand() < 0.35),
        px - l * dx, py - l * dy, pz - l * dz, px + w * wx, py + w * wy, pz + w * wz,
        px + l * dx, py + l * dy, pz + l * dz, px - w * wx, py - w * wy, pz - w * wz
    }
    print "cylinder 10  0 -0.45 0  0.018 0.6"
    for (i = 0; i < 7 * (seed == 1); ++i) {       # lemons grow on one of them
      a = 0.9 * i + 0.4; y = 0.05 - 0.1 * (i % 3)
      printf "begin 13 translate %.3f %.3f %.3f rotate %d 1 0 1 scale 0.034 0.044 0.034  sphere 13  0 0 0  1  end\n",
        0.35 * cos(a), y, 0.35 * sin(a), 20 * i
    }
  }'
}
tree() {
  printf 'mesh 20 pot.obj smooth\ncylinder 21  0 0.29 0  0.2 0.04\nbegin -1 translate 0 1.02 0\n'
  leaves "$@"
  echo end
}
tree 2600 1 | part lemon_tree
tree 2600 2 | part olive_tree

# Pots, a carafe, lemonade in it, and a bowl, turned on a lathe.
lathe() { awk -v around=64 -v smooth="$1" -f "$here/script/art/lathe.awk"; }
lathe 0 > "$out/pot.obj" << END
0 0
0.15 0

0.15 0
0.21 0.3

0.21 0.3
0.23 0.3

0.23 0.3
0.23 0.35

0.23 0.35
0.2 0.35

0.2 0.35
0.19 0.31
0 0.31
END
lathe 8 > "$out/carafe.obj" << END
0 0.004
0.05 0
0.062 0.02
0.064 0.09
0.048 0.16
0.034 0.2
0.034 0.235
0.042 0.262

0.042 0.262
0.0405 0.262

0.0405 0.262
0.032 0.236
0.0315 0.2
0.046 0.158
0.0612 0.09
0.059 0.022
0.045 0.008
0 0.009
END
lathe 8 > "$out/lemonade.obj" << END
0 0.0088
0.0452 0.0078
0.0592 0.0218
0.0613 0.09
0.0545 0.128

0.0545 0.128
0 0.128
END
lathe 6 > "$out/bowl.obj" << END
0 0
0.06 0
0.13 0.06
0.15 0.075

0.15 0.075
0.148 0.079

0.148 0.079
0.125 0.066
0.05 0.012
0 0.012
END

{
  cat << END
box 18  -4.3 -0.3 -3.1  4.3 -0.008 4.9
plane 16  0 -40 0  0 1 0
begin 17 translate -260 -40 -640 scale 190 55 60  sphere 17  0 0 0  1  end
begin 17 translate -60 -40 -760 scale 130 70 60  sphere 17  0 0 0  1  end
begin 17 translate 330 -40 -800 scale 240 50 60  sphere 17  0 0 0  1  end
END
  tiles
  wall
} | part place

# A round table of iron, and what stands on it.
part table << END
cylinder 9  0 0.725 0  0.4 0.012
torus 9  0 0.725 0  0.4 0.012
cylinder 6  0 0.732 0  0.385 0.003
cylinder 9  0 0.37 0  0.022 0.7
cone 9  0 0.05 0  0.2 0.1
begin -1 translate 0.1 0.7336 -0.08
  mesh 14 carafe.obj smooth
  mesh 15 lemonade.obj smooth
end
begin -1 translate -0.13 0.7336 0.0  include tumbler.scn  end
begin -1 translate 0.14 0.7336 0.16  include tumbler.scn  end
begin -1 translate -0.06 0.7336 -0.2
  mesh 19 bowl.obj smooth
  begin 13 translate 0.035 0.05 0.03 rotate 40 0 1 0 scale 0.034 0.034 0.045  sphere 13  0 0 0  1  end
  begin 13 translate -0.045 0.052 0.02 rotate 110 0 1 0 scale 0.033 0.033 0.043  sphere 13  0 0 0  1  end
  begin 13 translate 0.0 0.054 -0.05 rotate 80 0 1 0 scale 0.035 0.035 0.046  sphere 13  0 0 0  1  end
  begin 13 translate 0.0 0.1 0.005 rotate 15 0 1 0 scale 0.034 0.034 0.044  sphere 13  0 0 0  1  end
end
END
# The drink reaches a little into the glass, which has the higher priority and so fills what both would.
part tumbler << END
csg difference 14
  cylinder 14  0 0.055 0  0.034 0.11
  cylinder 14  0 0.065 0  0.0315 0.11
end
cylinder 15  0 0.04 0  0.0318 0.062
END
