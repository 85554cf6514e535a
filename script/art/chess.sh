#!/bin/sh
# Makes art/chess/: the pieces of a chess set, of which all but the knight are lathed, the position in which Morphy's opera
# game of 1858 ended, and the wood of the board. A square is 1 wide; files a to h go along x, ranks 1 to 8 along -z.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
rayimg=${RAYIMG:-$here/build/rayimg}
out=$here/art/chess
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

# A foot that all pieces share, scaled to a radius, then what stands on it: its profile, from the foot up.
#   lathe name radius
lathe() {
  awk -v scale="$2" 'BEGIN {
    n = split("0 0 .94 0;;.94 0 1 .03 1 .16 .94 .22;;.94 .22 .82 .25 .80 .30;;.80 .30 .84 .36 .80 .43 .70 .46", lines, ";")
    for (i = 1; i <= n; ++i) {
      m = split(lines[i], number, " ")
      for (k = 1; k < m; k += 2) print number[k] * scale, number[k + 1] * 0.3
      if (!m) print ""
    }
    print ""
  } { print }' | awk -v around=32 -v smooth=5 -f "$here/script/art/lathe.awk" > "$out/$1.obj"
}

lathe pawn 0.28 <<'END'
0.196 0.138
0.15 0.20
0.105 0.32
0.09 0.46

0.09 0.46
0.17 0.47
0.18 0.49
0.17 0.51
0.09 0.53

0.09 0.53
0.125 0.57
0.165 0.64
0.172 0.71
0.15 0.79
0.09 0.85
0 0.872
END

lathe rook 0.33 <<'END'
0.231 0.138
0.19 0.22
0.165 0.40
0.16 0.60

0.16 0.60
0.215 0.62
0.22 0.65
0.20 0.68

0.20 0.68
0.225 0.72
0.235 0.80

0.235 0.80
0.155 0.80
0.155 0.77

0.155 0.77
0 0.76
END

lathe bishop 0.33 <<'END'
0.231 0.138
0.17 0.22
0.115 0.42
0.09 0.74

0.09 0.74
0.175 0.75
0.185 0.77
0.175 0.79
0.10 0.81

0.10 0.81
0.13 0.84
0.12 0.86
0.09 0.87

0.09 0.87
0.15 0.93
0.165 1.00
0.14 1.10
0.08 1.19
0.035 1.215

0.035 1.215
0.055 1.24
0.05 1.28
0 1.295
END

lathe queen 0.36 <<'END'
0.252 0.138
0.19 0.22
0.125 0.50
0.10 0.92

0.10 0.92
0.195 0.93
0.205 0.955
0.19 0.98
0.11 1.00

0.11 1.00
0.15 1.03
0.14 1.05
0.11 1.065

0.11 1.065
0.125 1.17
0.20 1.36

0.20 1.36
0.15 1.33
0.13 1.36

0.13 1.36
0.08 1.42
0.055 1.43

0.055 1.43
0.07 1.46
0.05 1.50
0 1.515
END

lathe king 0.37 <<'END'
0.259 0.138
0.195 0.22
0.13 0.52
0.105 0.98

0.105 0.98
0.205 0.99
0.215 1.015
0.20 1.04
0.115 1.06

0.115 1.06
0.155 1.09
0.145 1.11
0.115 1.125

0.115 1.125
0.13 1.24
0.195 1.43

0.195 1.43
0.17 1.465
0.05 1.51
0 1.515
END

# The foot of the knight alone.
lathe foot 0.33 <<'END'
0.231 0.138
0.215 0.165
0.205 0.19

0.205 0.19
0 0.195
END

# Its head: the outline of a horse, seen from the side and rounded by a spline, in layers of which the outer are smaller.
# Faces between layers are shaded smoothly, in smoothing group 1; the flat sides are far in and hardly seen.
awk '
  function spline(a, b, c, d, t) {  # between b and c; Catmull and Rom, A Class of Local Interpolating Splines (1974)
    return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
  }
  { x[NR - 1] = $1; y[NR - 1] = $2 }
  END {
    print "# The head of a knight, made by script/art/chess.sh."
    steps = 4; many = NR * steps; layers = 9
    for (l = 0; l < layers; ++l) {
      side = 2 * l / (layers - 1) - 1; inset = 0.075 * (1 - sqrt(1 - 0.96 * side * side))
      for (k = 0; k < NR; ++k)
        for (s = 0; s < steps; ++s) {
          a = (k + NR - 1) % NR; b = k; c = (k + 1) % NR; d = (k + 2) % NR; t = s / steps
          px = spline(x[a], x[b], x[c], x[d], t); py = spline(y[a], y[b], y[c], y[d], t)
          e = (s + 1) / steps  # the direction along the outline, whose left is outside: it is walked clockwise
          dx = spline(x[a], x[b], x[c], x[d], t + 0.05) - px; dy = spline(y[a], y[b], y[c], y[d], t + 0.05) - py
          length_ = sqrt(dx * dx + dy * dy)
          wide = 0.15 - 0.055 * (py - 0.2)
          printf "v %.4f %.4f %.4f\n", px + inset * dy / length_, py - inset * dx / length_ * (py > 0.25 ? 1 : 0), side * wide
        }
    }
    print "s 1"
    for (l = 0; l + 1 < layers; ++l)
      for (k = 0; k < many; ++k) {
        p = l * many + k + 1; q = l * many + (k + 1) % many + 1
        print "f", p, p + many, q + many, q
      }
    print "s off"
    face = "f"; for (k = 0; k < many; ++k) face = face " " k + 1
    print face
    face = "f"; for (k = many - 1; k >= 0; --k) face = face " " (layers - 1) * many + k + 1
    print face
  }' > "$out/horse.obj" <<'END'
-0.20 0.18
-0.23 0.34
-0.21 0.52
-0.15 0.70
-0.10 0.84
-0.06 0.95
-0.045 1.06
0.00 0.985
0.05 0.95
0.12 0.87
0.19 0.79
0.27 0.70
0.285 0.645
0.265 0.60
0.21 0.585
0.15 0.615
0.10 0.63
0.055 0.60
0.07 0.53
0.13 0.42
0.185 0.30
0.20 0.18
END

# What stands on which square. Each piece is a mesh, and what the lathe cannot make.
awk '
  function body(piece,   k, text) {
    text = "mesh -1 " (piece == "knight" ? "foot" : piece) ".obj smooth"
    if (piece == "knight")
      text = text " mesh -1 horse.obj smooth sphere -1 0.075 0.815 0.098 0.022 sphere -1 0.075 0.815 -0.098 0.022"
    if (piece == "king") text = text " box -1 -0.028 1.49 -0.028 0.028 1.70 0.028 box -1 -0.085 1.575 -0.027 0.085 1.632 0.027"
    for (k = 0; k < 9 && piece == "queen"; ++k)
      text = text sprintf(" sphere -1 %.3f 1.37 %.3f 0.035", 0.178 * cos(k * 0.69813), 0.178 * sin(k * 0.69813))
    for (k = 0; k < 6 && piece == "rook"; ++k)
      text = text sprintf("\n  begin -1 rotate %d 0 1 0 box -1 0.158 0.79 -0.072 0.226 0.90 0.072 end", 60 * k)
    return text
  }
  function put(piece, material, x, y, z, turn) {
    printf "begin %d translate %.3f %g %.3f rotate %d 0 1 0\n  %s\nend\n", material, x, y, z, turn, body(piece)
  }
  function all(material, turn, text,   words, n, k, x, z) {
    n = split(text, words, " ")
    for (k = 1; k < n; k += 2) {
      x = index("abcdefgh", substr(words[k + 1], 1, 1)) - 4.5; z = 4.5 - substr(words[k + 1], 2, 1)
      put(words[k], material, x + 0.05 * sin(37 * x + 11 * z), 0, z + 0.05 * sin(23 * x + 19 * z), turn + 20 * sin(3 * k))
    }
  }
  BEGIN {
    print "# The opera game, Morphy against the Duke of Brunswick and Count Isouard, Paris 1858: 17. Rd8 mates."
    print "material 0 0 0  0.66 0.43 0.22  0.02 0.02 0.02  0 0 0  0 0 0  90 1 0   # 0 maple"
    print "coat 0 1.5"
    print "material 0 0 0  0.050 0.020 0.012  0.02 0.02 0.02  0 0 0  0 0 0  90 1 0   # 1 walnut"
    print "coat 1 1.5"
    all(0, 90, "king c1 rook d8 bishop g5 pawn a2 pawn b2 pawn c2 pawn e4 pawn f2 pawn g2 pawn h2")
    all(1, -90, "king e8 queen e6 knight b8 bishop f8 rook h8 pawn a7 pawn e5 pawn f7 pawn g7 pawn h7")
    print "# Taken, beside the board."
    put("knight", 1, -5.6, -0.4, 1.2, 20); put("bishop", 1, -5.3, -0.4, 0.3, 0)
    put("rook", 1, -6.0, -0.4, -0.4, 160); put("pawn", 1, -5.2, -0.4, -1.0, 0)
    put("queen", 0, 5.5, -0.4, -1.4, 0); put("rook", 0, 5.9, -0.4, -0.3, 40); put("knight", 0, 5.3, -0.4, 0.6, 200)
  }' > "$out/position.scn"

# Squares of maple and walnut inside of a frame; the top is y = 0.
awk 'BEGIN {
  print "# A board of 64 squares."
  print "material 0 0 0  0.80 0.72 0.60  0 0 0  0 0 0  0 0 0  60 1 maple.jpg   # 0"
  print "coat 0 1.5"
  print "material 0 0 0  0.16 0.075 0.045  0 0 0  0 0 0  0 0 0  60 1 maple.jpg   # 1"
  print "coat 1 1.5"
  print "material 0 0 0  0.10 0.045 0.028  0 0 0  0 0 0  0 0 0  60 1 maple.jpg   # 2 frame"
  print "coat 2 1.5"
  for (i = 0; i < 8; ++i)
    for (j = 0; j < 8; ++j)
      printf "begin -1 translate %g 0 %g rotate %d 0 1 0  box %d  -0.497 -0.06 -0.497  0.497 0 0.497  end\n", i - 3.5, 3.5 - j,
        (i * 5 + j * 3) % 4 * 90, (i + j) % 2 ? 0 : 1
  print "box 2  -4 -0.39 -4  4 -0.02 4"
  for (k = 0; k < 4; ++k)
    printf "begin -1 rotate %d 0 1 0  box 2  -4.5 -0.39 4.001  4.0 0.03 4.5  end\n", 90 * k
}' > "$out/board.scn"

# Wood, cut along: rings that a slow sum of waves bends.
awk -v size=512 '
  function wave(u, v, seed) {
    return sin(3.1 * u + 2.3 * v + seed) + 0.5 * sin(7.3 * u - 1.9 * v + 2 * seed) + 0.25 * sin(1.7 * u + 11 * v + 3 * seed)
  }
  BEGIN {
    printf "P3\n%d %d\n255\n", size, size
    for (y = 0; y < size; ++y)
      for (x = 0; x < size; ++x) {
        across = y / size; along = x / size * 1.5
        stripe = 9 * across + 0.35 * wave(along, across * 2, 1.7) + 3 * across * across
        stripe -= int(stripe); if (stripe < 0) ++stripe
        dark = stripe < 0.8 ? stripe / 0.8 : (1 - stripe) / 0.2
        grain = sin(310 * across + 5 * wave(along, across * 3, 2)) * sin(31 * along + 60 * across)
        tone = 0.94 - 0.16 * dark * dark + 0.014 * grain
        printf "%d %d %d\n", 246 * tone, 224 * tone * tone, 182 * tone * tone
      }
  }' > "$work/maple.ppm"
case $rayimg in /*) ;; *) rayimg=$PWD/$rayimg ;; esac
(cd "$work" && "$rayimg" convert maple.ppm maple.jpg -jpeg_quality 85)
cp "$work/maple.jpg" "$out/maple.jpg"
