#!/bin/sh
# Makes art/crystal/: a cut egg of 10,000 facets, and a brilliant of 57 facets.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/crystal
mkdir -p "$out"

# A cut egg: 50 belts of 50 pyramids with four sides each are 10,000 facets, and a lid closes each end. The belts are
# spaced as parallels are on a map of Mercator, which makes every pyramid stand on a square.
awk -v around=50 -v belts=50 '
  function point(turn, latitude, out,   r, y) {
    r = cos(latitude) * out; y = sin(latitude) * out
    printf "v %.6g %.6g %.6g\n", r * cos(turn), y * (y < 0 ? 1.1 : 1.45), r * sin(turn)
  }
  function latitude(belt,   e) {  # the Gudermannian function
    e = exp(2 * pi * (belt - belts / 2) / around)
    return 2 * atan2(e, 1) - pi / 2
  }
  function corner(belt, k) { return belt * around + k % around + 1 }
  BEGIN {
    pi = atan2(0, -1); cut = 0.42  # height of a pyramid, in halves of its side
    print "# An egg of " 4 * around * belts " facets and two lids, its middle at the origin."
    for (j = 0; j <= belts; ++j)
      for (k = 0; k < around; ++k) point(2 * pi * k / around, latitude(j), 1)
    for (j = 0; j < belts; ++j)
      for (k = 0; k < around; ++k) {
        half = pi / around * cos(latitude(j + 0.5))
        point(2 * pi * (k + 0.5) / around, latitude(j + 0.5), 1 + cut * half)
      }
    for (j = 0; j < belts; ++j)
      for (k = 0; k < around; ++k) {
        tip = (belts + 1) * around + j * around + k + 1
        print "f", corner(j, k + 1), corner(j, k), tip
        print "f", corner(j + 1, k + 1), corner(j, k + 1), tip
        print "f", corner(j + 1, k), corner(j + 1, k + 1), tip
        print "f", corner(j, k), corner(j + 1, k), tip
      }
    printf "f"; for (k = 0; k < around; ++k) printf " %d", corner(0, k); print ""
    printf "f"; for (k = around; k > 0; --k) printf " %d", corner(belts, k); print ""
  }' > "$out/egg.obj"

# A brilliant: table, 8 stars, 8 kites and 16 triangles above the girdle, 16 triangles and 8 kites below. A kite is flat:
# its side corners lie on the line of its profile from end to end.
awk '
  function ring(r, y, half,   k) {
    for (k = 0; k < 8; ++k)
      printf "v %.7g %.7g %.7g\n", r * cos(pi / 4 * (k + half)), y, r * sin(pi / 4 * (k + half))
  }
  function at(which, k) { return 8 * which + k % 8 + 1 }
  BEGIN {
    pi = atan2(0, -1); table = 0.55; crown = 0.33; culet = -0.84
    upper = 0.80; lower = 0.26; flat = cos(pi / 8)
    print "# A brilliant of 57 facets; its girdle is the unit circle of the plane y = 0."
    ring(table, crown, 0)                                                   # ring 0
    ring(upper, crown * (1 - (upper * flat - table) / (1 - table)), 0.5)    # 1: between kites
    ring(1, 0, 0); ring(1, 0, 0.5)                                          # 2, 3: the girdle
    ring(lower, culet * (1 - lower * flat), 0.5)                            # 4
    print "v 0", culet, 0
    printf "f"; for (k = 7; k >= 0; --k) printf " %d", at(0, k); print ""
    for (k = 0; k < 8; ++k) {
      print "f", at(0, k), at(0, k + 1), at(1, k)
      print "f", at(0, k), at(1, k), at(2, k), at(1, k + 7)
      print "f", at(1, k), at(3, k), at(2, k)
      print "f", at(1, k), at(2, k + 1), at(3, k)
      print "f", at(4, k), at(2, k), at(3, k)
      print "f", at(4, k), at(3, k), at(2, k + 1)
      print "f", 41, at(4, k + 7), at(2, k), at(4, k)
    }
  }' > "$out/brilliant.obj"
