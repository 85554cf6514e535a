#!/bin/sh
# Makes art/cradle/: Newton's cradle with its first ball swinging. A `motion` goes straight, the same for all of its
# group; a thread turns about its upper end. So a thread is cut into pieces, each of which goes as far as its middle.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/cradle
mkdir -p "$out"

awk '
  function matrix(a, x, y, tilt,   ca, sa, ct, st) {  # tilted about x, then swung about z, then moved
    ca = cos(a); sa = sin(a); ct = cos(tilt); st = sin(tilt)
    printf "%.6g %.6g %.6g %.6g  %.6g %.6g %.6g %.6g  0 %.6g %.6g 0  0 0 0 1", ca, -sa * ct, sa * st, x, sa, ca * ct,
      -ca * st, y, st, ct
  }
  function pendulum(x, a0, a1,   pieces, side, k, depth, moving) {  # hangs at x, swings from angle a0 to a1
    moving = a0 != a1
    pieces = moving ? 24 : 1
    for (side = -1; side <= 1; side += 2)
      for (k = 0; k < pieces; ++k) {
        depth = drop * (k + 0.5) / pieces
        printf "begin 1  "
        place(x, a0, side, k, pieces)
        if (moving) motion(depth, a0, a1)
        printf "  cylinder -1  0 0 0  0.018 %.6g  end\n", 1.01 * sqrt(drop * drop + half * half) / pieces
      }
    printf "begin 0  "; matrix(a0, x + drop * sin(a0), top - drop * cos(a0), 0)
    if (moving) motion(drop, a0, a1)
    print "  sphere -1  0 0 0  0.5  cylinder 1  0 0.5 0  0.06 0.12  end"
  }
  # The middle of piece k lies (k + 1/2) of the way from the bar, at z = side * half, to the ball, at z = 0.
  function place(x, a, side, k, pieces,   share, depth) {
    share = (k + 0.5) / pieces; depth = drop * share
    tilt = side * atan2(half, drop)
    ca = cos(a); sa = sin(a); ct = cos(tilt); st = sin(tilt)
    printf "%.6g %.6g %.6g %.6g  %.6g %.6g %.6g %.6g  0 %.6g %.6g %.6g  0 0 0 1", ca, -sa * ct, sa * st, x + depth * sa,
      sa, ca * ct, -ca * st, top - depth * ca, st, ct, side * half * (1 - share)
  }
  function motion(depth, a0, a1) {
    printf "  motion %.6g %.6g 0 ", depth * (sin(a1) - sin(a0)), depth * (cos(a0) - cos(a1))
  }
  BEGIN {
    pi = atan2(0, -1); top = 4.2; drop = 3; half = 1.1
    print "# Newton'"'"'s cradle, its first ball on the way down. It stands on y = 0."
    print "material  0 0 0  0.02 0.02 0.022  0.90 0.90 0.92  0 0 0  0 0 0  100000 1 0   # 0 chrome"
    print "material  0 0 0  0.45 0.45 0.45  0.2 0.2 0.2  0 0 0  0 0 0  60 1 0           # 1 thread"
    print "material  0 0 0  0.03 0.02 0.015  0.10 0.10 0.10  0 0 0  0 0 0  4000 1 0      # 2 lacquer"
    pendulum(-2, -0.78, -0.69)
    for (i = -1; i <= 2; ++i) pendulum(i, 0, 0)
    for (side = -1; side <= 1; side += 2) {
      printf "begin 0  0 1 0 0  -1 0 0 %.6g  0 0 1 %.6g  0 0 0 1  cylinder -1  0 0 0  0.07 6.4  end\n", top, side * half
      for (end = -1; end <= 1; end += 2) {
        printf "cylinder 0  %.6g %.6g %.6g  0.07 %.6g\n", end * 3.2, (top + 0.3) / 2, side * half, top - 0.3
        printf "sphere 0  %.6g %.6g %.6g  0.07\n", end * 3.2, top, side * half
      }
    }
    print "box 2  -3.6 0 -1.5  3.6 0.3 1.5"
  }' > "$out/cradle.scn"
