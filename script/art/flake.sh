#!/bin/sh
# Makes art/flake/: a flake of spheres as files that include one another, each nine times. flake4.scn stands for
# 7,381 spheres. Six children sit around the middle of a sphere and three above, a third as large.
# Source: Haines, A Proposal for Standard Graphics Environments (1987), the sphere flake.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/flake
mkdir -p "$out"

awk -v out="$out" -v written=1 '
  # Opens the group of a child whose own up direction is tilted from its parent'"'"'s y axis and turned around it.
  function open_child(tilt, turn,   ct, st, cp, sp) {
    ct = cos(tilt); st = sin(tilt); cp = cos(turn); sp = sin(turn)
    # Turned about z by the tilt, then about y; made a third as large, and moved out along its up by 1 + 1/3.
    printf "begin -1  %.7g %.7g %.7g %.7g  %.7g %.7g 0 %.7g  %.7g %.7g %.7g %.7g  0 0 0 1\n",
      cp * ct / 3, cp * st / 3, sp / 3, cp * st * 4 / 3,  -st / 3, ct / 3, ct * 4 / 3,
      -sp * ct / 3, -sp * st / 3, cp / 3, -sp * st * 4 / 3 > file
  }
  # A file may stand for 10,000 others at most, so the smallest are written out.
  function flake(level, top,   i) {
    if (!top && level >= written) { print "include flake" level ".scn" > file; return }
    print "sphere", (level <= written ? level : 0), " 0 0 0  1" > file
    if (level > 0)
      for (i = 0; i < 9; ++i) {
        if (i < 6) open_child(pi / 2, i * pi / 3)
        else open_child(pi / 6, pi / 6 + i * 2 * pi / 3)
        flake(level - 1, 0)
        print "end" > file
      }
  }
  function material(level) { printf "material  0 0 0  %s  0 0 0  0 0 0  100000 1 0\n", metal[level] > file }
  BEGIN {
    pi = atan2(0, -1)
    # Metals, from the smallest to the largest: kd, then ks.
    metal[0] = "0 0 0  0.86 0.30 0.22"
    metal[1] = "0 0 0  0.88 0.52 0.24"
    metal[2] = "0 0 0  0.90 0.70 0.32"
    metal[3] = "0 0 0  0.88 0.84 0.70"
    metal[4] = "0 0 0  0.72 0.78 0.84"
    for (level = written; level <= 4; ++level) {
      file = out "/flake" level ".scn"
      print "# A flake of spheres with " level " generations of children." > file
      if (level > written) material(level)
      else for (i = 0; i <= written; ++i) material(i)
      flake(level, 1)
      close(file)
    }
  }'
