#!/bin/sh
# Makes art/glass/: a wine glass, its wine, a bottle, and the wood of the table they stand on.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
rayimg=${RAYIMG:-$here/build/rayimg}
out=$here/art/glass
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
lathe() { awk -v around="$1" -v smooth="$2" -f "$here/script/art/lathe.awk"; }

# The foot, stem and bowl outside, then the bowl inside; the foot stands on y = 0.
lathe 40 18 > "$out/wineglass.obj" <<'END'
0 0
0.4 0
0.72 0.01

0.72 0.01
0.70 0.045
0.40 0.09
0.12 0.16
0.065 0.40
0.06 0.85
0.075 1.15
0.16 1.30
0.45 1.48
0.70 1.80
0.78 2.20
0.72 2.65
0.62 2.98

0.62 2.98
0.60 3.00
0.585 2.98

0.585 2.98
0.685 2.65
0.745 2.20
0.665 1.82
0.43 1.53
0.15 1.38
0 1.36
END

# A little smaller than the bowl inside: light crosses a film of air there.
lathe 40 10 > "$out/wine.obj" <<'END'
0 1.372
0.147 1.392
0.424 1.541
0.655 1.829
0.725 2.02

0.725 2.02
0.35 2.02
0 2.02
END

lathe 40 16 > "$out/bottle.obj" <<'END'
0 0.06
0.45 0.02
0.62 0

0.62 0
0.68 0.03
0.70 0.12
0.70 1.2
0.70 2.1
0.66 2.42
0.42 2.78
0.26 3.02
0.225 3.4
0.225 3.85

0.225 3.85
0.28 3.88
0.28 4.02
0.225 4.05
0.17 4.03

0.17 4.03
0.16 3.4
0.19 3.02
0.36 2.74
0.595 2.36
0.625 2.1
0.625 1.2
0.62 0.25
0.5 0.14
0 0.16
END

# Planks of wood, of the width of the table: rings that a slow sum of waves bends, in browns that differ by plank.
awk -v width=512 -v height=512 '
  function wave(u, v, seed) {
    return sin(3.1 * u + 2.3 * v + seed) + 0.5 * sin(7.3 * u - 1.9 * v + 2 * seed) \
      + 0.25 * sin(1.7 * u + 11 * v + 3 * seed)
  }
  BEGIN {
    printf "P3\n%d %d\n255\n", width, height
    planks = 4
    for (y = 0; y < height; ++y)
      for (x = 0; x < width; ++x) {
        plank = int(planks * y / height)
        across = planks * y / height - plank
        along = x / width * 3 + plank * 5.3
        ring = (across - 0.5) * 2.2 + 0.18 * wave(along, across, plank * 1.7)
        stripe = 7 * ring * ring + 3 * ring + 0.3 * wave(along * 0.4, across * 5, plank)
        stripe -= int(stripe); if (stripe < 0) ++stripe
        dark = stripe < 0.8 ? stripe / 0.8 : (1 - stripe) / 0.2
        grain = sin(260 * across + 9 * wave(along, across * 3, 2)) * sin(19 * along + 40 * across)
        tone = 0.82 - 0.30 * dark * dark + 0.035 * grain + 0.06 * sin(plank * 2.4)
        if (across < 0.012 || across > 0.988) tone *= 0.35
        printf "%d %d %d\n", 205 * tone, 140 * tone, 88 * tone
      }
  }' > "$work/wood.ppm"
# The image keeps the command that made it: without a temporary folder in it, its bytes stay the same.
case $rayimg in /*) ;; *) rayimg=$PWD/$rayimg ;; esac
(cd "$work" && "$rayimg" convert wood.ppm wood.jpg -jpeg_quality 85)
cp "$work/wood.jpg" "$out/wood.jpg"
