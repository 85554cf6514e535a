#!/bin/sh
# Makes art/library/: shelves of thousands of books, a floor of boards, windows, a table with lamps and chairs, and a
# ladder. Meters; the windows are at x = 0, the shelves at x = 7, the room goes from z = 1 to z = -13.
# A pseudo-random sequence of our own, so that every awk builds the same room: x' = 16807 x mod 2^31 - 1.
# Source: Park and Miller, Random Number Generators: Good Ones Are Hard to Find (1988).
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
out=$here/art/library
mkdir -p "$out"

awk -v out="$out" '
  function random() { state = (state * 16807) % 2147483647; return state / 2147483647 }
  # The number of a new one, which all files have.
  function material(diffuse, specular, exponent, emission) {
    list = list "material  0 0 0  " diffuse "  " specular "  0 0 0  " (emission == "" ? "0 0 0" : emission) "  " exponent " 1 0\n"
    return materials++
  }
  function file(name) { name = out "/" name ".scn"; printf "%s", list > name; return name }
  function box(to, kind, x0, y0, z0, x1, y1, z1) {
    printf "box %d  %.4g %.4g %.4g  %.4g %.4g %.4g\n", kind, x0, y0, z0, x1, y1, z1 > to
  }
  # Books on a board from u0 to u1, in the frame of a shelf: u along it, y up, its back at w = 0, and readers at w > 0.
  # They stand in runs of one kind, as series do; some lean, and here and there is a gap.
  function books(u0, u1, y, room,   u, kind, run, width, height, depth, lean, s, c) {
    u = u0 + 0.01; run = 0
    while (1) {
      if (run <= 0) {
        kind = first_binding + int(bindings * random()); run = int(1 + 9 * random() * random())
        width = 0.022 + 0.035 * random(); height = room * (0.62 + 0.32 * random()); depth = 0.17 + 0.07 * random()
        if (random() < 0.07) u += 0.05 + 0.2 * random()
      }
      --run
      if (u + width > u1 - 0.01) break
      if (random() < 0.015 && u + 0.16 < u1) {
        s = 0.17; c = 0.9854  # sine and cosine of ten degrees
        printf "begin -1  %.4g %.4g 0 %.4g  %.4g %.4g 0 %.4g  0 0 1 0  0 0 0 1\n", c, s, u, -s, c, y + s * width > shelf
        book(0, width, 0, height * 0.95, depth, kind)
        print "end" > shelf
        u += width * c + height * s; run = 0
        continue
      }
      book(u, u + width, y, y + height * (0.985 + 0.015 * random()), depth - 0.008 * random(), kind)
      u += width + 0.0015
    }
  }
  # Its boards, with a label and bands of gold on the back of some.
  function book(u0, u1, y0, y1, depth, kind,   i, at) {
    box(shelf, kind, u0, y0, 0.02, u1, y1, depth)
    if (kind % 3 == 0) return
    at = y0 + 0.72 * (y1 - y0)
    if (kind % 3 == 1) box(shelf, label, u0 + 0.002, at, depth, u1 - 0.002, at + 0.045, depth + 0.0008)
    for (i = 0; i < 2; ++i) {
      at = y0 + (0.12 + 0.74 * i) * (y1 - y0)
      box(shelf, gold, u0, at, depth, u1, at + 0.006, depth + 0.001)
    }
  }
  # A case of bays, each `wide`, with boards to the height of 4.6.
  function bookcase(name, bays, wide,   bay, row, u, y, tall) {
    shelf = file(name)
    for (bay = 0; bay <= bays; ++bay) {
      u = bay * wide
      box(shelf, wood, u - 0.05, 0, 0, u + 0.05, 4.75, 0.34)
      box(shelf, wood, u - 0.075, 0, 0, u + 0.075, 0.5, 0.40)
      box(shelf, wood, u - 0.075, 4.55, 0, u + 0.075, 4.75, 0.40)
    }
    box(shelf, wood, 0, 0, -0.03, bays * wide, 4.75, 0.01)
    box(shelf, wood, 0, 0, 0, bays * wide, 0.42, 0.36)
    box(shelf, wood, -0.1, 4.75, 0, bays * wide + 0.1, 4.87, 0.46)
    box(shelf, wood, -0.1, 4.87, 0, bays * wide + 0.1, 4.93, 0.52)
    for (bay = 0; bay < bays; ++bay) {
      u = bay * wide
      box(shelf, wood, u + 0.12, 0.08, 0.36, u + wide - 0.12, 0.36, 0.37)
      y = 0.42
      for (row = 0; row < 11; ++row) {
        tall = row < 2 ? 0.46 : 0.37
        books(u + 0.05, u + wide - 0.05, y, tall - 0.03)
        y += tall
        if (y > 4.55) break
        box(shelf, wood, u, y - 0.028, 0, u + wide, y, 0.30)
      }
    }
  }
  # A window in the wall at x = 0, between z0 and z0 - wide: a frame and bars.
  function window(z0, wide,   low, high, i, at, z1) {
    low = 0.95; high = 4.45; z1 = z0 - wide
    for (i = 0; i <= 3; ++i) {
      at = z0 - i * wide / 3
      box(room, white, -0.16, low, at - 0.03, -0.10, high, at + 0.03)
    }
    for (i = 0; i <= 5; ++i) {
      at = low + i * (high - low) / 5
      box(room, white, -0.16, at - 0.03, z1, -0.10, at + 0.03, z0)
    }
    box(room, stone, -0.40, low - 0.08, z1 - 0.08, 0.12, low, z0 + 0.08)
  }
  function chair(x, z, side) {  # looks towards the table: side 1 to +x
    printf "begin -1  %d 0 0 %.4g  0 1 0 0  0 0 %d %.4g  0 0 0 1\n", side, x, side, z > furniture
    print "include chair.scn  end" > furniture
  }
  BEGIN {
    state = 20011
    wood = material("0.2 0.095 0.045", "0.06 0.06 0.06", 40)
    white = material("0.7 0.68 0.64", "0 0 0", 1)
    stone = material("0.5 0.47 0.42", "0.05 0.05 0.05", 30)
    plaster = material("0.78 0.74 0.66", "0 0 0", 1)
    sky = material("0 0 0", "0 0 0", 1, "8 9 10.5")
    gold = material("0.42 0.28 0.07", "0.35 0.26 0.1", 30)
    label = material("0.3 0.05 0.03", "0.02 0.02 0.02", 20)
    board = material("0.34 0.2 0.1", "0.1 0.09 0.08", 80)
    material("0.29 0.165 0.08", "0.1 0.09 0.08", 80)
    material("0.38 0.235 0.125", "0.1 0.09 0.08", 80)
    material("0.25 0.135 0.065", "0.1 0.09 0.08", 80)
    carpet = material("0.22 0.025 0.03", "0 0 0", 1)
    border = material("0.42 0.3 0.14", "0 0 0", 1)
    leather = material("0.04 0.13 0.08", "0.04 0.04 0.04", 25)
    brass = material("0.1 0.07 0.02", "0.62 0.47 0.2", 300)
    glass = material("0.01 0.2 0.09", "0.1 0.1 0.1", 500)
    paper = material("0.78 0.74 0.62", "0 0 0", 1)
    first_binding = material("0.3 0.05 0.04", "0.03 0.03 0.03", 20)
    material("0.22 0.1 0.04", "0.03 0.03 0.03", 20)
    material("0.05 0.13 0.08", "0.03 0.03 0.03", 20)
    material("0.05 0.09 0.2", "0.03 0.03 0.03", 20)
    material("0.36 0.24 0.11", "0.03 0.03 0.03", 20)
    material("0.14 0.05 0.05", "0.03 0.03 0.03", 20)
    material("0.44 0.37 0.25", "0.02 0.02 0.02", 20)
    material("0.1 0.1 0.11", "0.03 0.03 0.03", 20)
    material("0.12 0.17 0.06", "0.03 0.03 0.03", 20)
    material("0.3 0.15 0.04", "0.03 0.03 0.03", 20)
    material("0.06 0.14 0.17", "0.03 0.03 0.03", 20)
    material("0.2 0.03 0.07", "0.03 0.03 0.03", 20)
    bindings = materials - first_binding
    room = file("room"); furniture = file("furniture"); chairs = file("chair")

    bookcase("side", 10, 1.3)
    bookcase("end", 5, 1.3)

    # Piers and the wall above and below the windows, 0.4 deep.
    for (i = 0; i < 5; ++i) box(room, plaster, -0.4, 0, -13 + 3.2 * i - 0.75, 0, 5.6, -13 + 3.2 * i + 0.65)
    for (i = 0; i < 4; ++i) {
      window(-13 + 3.2 * (i + 1) - 0.75, 1.8)
      box(room, plaster, -0.4, 0, -13 + 3.2 * i + 0.65, 0, 0.87, -13 + 3.2 * (i + 1) - 0.75)
      box(room, plaster, -0.4, 4.45, -13 + 3.2 * i + 0.65, 0, 5.6, -13 + 3.2 * (i + 1) - 0.75)
      box(room, wood, 0, 0.1, -13 + 3.2 * i + 0.75, 0.03, 0.8, -13 + 3.2 * (i + 1) - 0.85)
    }
    # The sky, which ends where the sun comes over it.
    printf "quad %d  -6 -3 8  -6 -3 -22  -6 4.9 -22  -6 4.9 8\n", sky > room
    box(room, plaster, -0.4, 0, -13.6, 7.6, 5.6, -13.4)
    box(room, plaster, 7.4, 0, -13.4, 7.6, 5.6, 3)
    box(room, plaster, -0.4, 0, 2.8, 7.6, 5.6, 3)
    box(room, plaster, -0.4, 0, 0.45, 0, 5.6, 3)
    box(room, plaster, -0.4, 5.5, -13.6, 7.6, 5.7, 3)
    for (i = 0; i < 9; ++i) box(room, wood, 0, 5.22, -12.6 + 1.6 * i - 0.12, 7.4, 5.5, -12.6 + 1.6 * i + 0.12)
    box(room, wood, 2.4, 5.3, -13.4, 2.65, 5.5, 3); box(room, wood, 4.8, 5.3, -13.4, 5.05, 5.5, 3)

    # Boards of four browns.
    for (i = 0; i < 62; ++i) {
      z = 3 - 2.4 * random()
      while (z > -13.4) {
        long = 1.4 + 1.6 * random()
        box(room, board + int(4 * random()), 0.12 * i, -0.02, z - long, 0.12 * i + 0.1185, 0, z - 0.0015)
        z -= long
      }
    }
    box(room, board, -0.4, -0.1, -13.6, 7.6, -0.02, 3)
    box(room, border, 1.75, 0, -11.3, 4.85, 0.008, -1.9)
    box(room, carpet, 1.9, 0, -11.15, 4.7, 0.010, -2.05)
    box(room, border, 2.05, 0, -11.0, 4.55, 0.011, -2.2)
    box(room, carpet, 2.1, 0, -10.95, 4.5, 0.012, -2.25)

    # The table, its lamps, books and chairs.
    box(furniture, wood, 2.6, 0.72, -10.2, 4.0, 0.78, -3.0)
    box(furniture, leather, 2.72, 0.78, -10.08, 3.88, 0.782, -3.12)
    box(furniture, wood, 2.72, 0.62, -10.08, 3.88, 0.72, -3.12)
    for (i = 0; i < 4; ++i) {
      z = -3.25 - 2.232 * i
      box(furniture, wood, 2.74, 0, z - 0.06, 2.86, 0.62, z + 0.06); box(furniture, wood, 3.74, 0, z - 0.06, 3.86, 0.62, z + 0.06)
    }
    for (i = 0; i < 3; ++i) {
      z = -4.3 - 2.3 * i
      printf "cylinder %d  3.3 0.79 %.4g  0.11 0.02   cylinder %d  3.3 0.98 %.4g  0.012 0.36\n", brass, z, brass, z > furniture
      printf "begin -1  1 0 0 3.3  0 0 -1 1.17  0 1 0 %.4g  0 0 0 1  cylinder %d  0 0 0  0.075 0.34  end\n", z, glass > furniture
    }
    for (i = 0; i < 9; ++i) {
      x = 2.85 + 0.8 * random(); z = -3.6 - 6.1 * random(); y = 0.782; n = 1 + int(4 * random())
      for (j = 0; j < n; ++j) {
        w = 0.15 + 0.05 * random(); d = 0.2 + 0.06 * random(); h = 0.02 + 0.03 * random(); a = 0.5 * random() - 0.25
        kind = first_binding + int(bindings * random())
        printf "begin -1  %.4g 0 %.4g %.4g  0 1 0 %.4g  %.4g 0 %.4g %.4g  0 0 0 1\n", cos(a), sin(a), x, y, -sin(a), cos(a), z > furniture
        box(furniture, kind, -w / 2, 0, -d / 2, w / 2, h, d / 2)
        box(furniture, paper, -w / 2 + 0.004, 0.003, -d / 2 - 0.001, w / 2 + 0.001, h - 0.003, d / 2 + 0.001)
        print "end" > furniture
        y += h
      }
    }
    # An open book near the camera.
    printf "tri %d  3.02 0.80 -3.52  3.20 0.80 -3.52  3.20 0.80 -3.26   tri %d  3.02 0.80 -3.52  3.20 0.80 -3.26  3.02 0.80 -3.26\n", paper, paper > furniture
    box(furniture, paper, 3.02, 0.782, -3.52, 3.195, 0.80, -3.26); box(furniture, paper, 3.205, 0.782, -3.52, 3.38, 0.80, -3.26)
    box(furniture, first_binding + 1, 3.01, 0.782, -3.53, 3.39, 0.785, -3.25)
    for (i = 0; i < 4; ++i) { chair(2.35, -4.0 - 1.6 * i, 1); chair(4.25, -4.4 - 1.6 * i, -1) }

    box(chairs, leather, -0.22, 0.43, -0.22, 0.24, 0.48, 0.22); box(chairs, wood, -0.24, 0.40, -0.24, 0.24, 0.43, 0.24)
    for (i = 0; i < 2; ++i) {
      z = i ? 0.21 : -0.21
      box(chairs, wood, -0.24, 0, z - 0.02, -0.20, 1.02, z + 0.02); box(chairs, wood, 0.19, 0, z - 0.02, 0.23, 0.4, z + 0.02)
    }
    box(chairs, wood, -0.235, 0.90, -0.21, -0.205, 1.02, 0.21); box(chairs, wood, -0.23, 0.66, -0.21, -0.21, 0.72, 0.21)
    for (i = 0; i < 4; ++i) box(chairs, wood, -0.23, 0.72, -0.15 + 0.1 * i - 0.012, -0.21, 0.90, -0.15 + 0.1 * i + 0.012)

    # The ladder, in a frame whose y goes up along it, leaning on the side shelves; and a globe by the end.
    printf "begin -1  0.9739 0.2269 0 6.05  -0.2269 0.9739 0 0  0 0 1 -5.6  0 0 0 1\n" > furniture
    box(furniture, wood, -0.02, 0.01, -0.27, 0.05, 4.5, -0.23); box(furniture, wood, -0.02, 0.01, 0.23, 0.05, 4.5, 0.27)
    for (i = 1; i < 15; ++i) box(furniture, wood, -0.01, 0.29 * i, -0.24, 0.04, 0.29 * i + 0.03, 0.24)
    print "end" > furniture
    printf "begin -1  0.9171 0.3987 0 5.35  -0.3987 0.9171 0 1.02  0 0 1 -4.1  0 0 0 1\n" > furniture
    printf "sphere %d  0 0 0  0.31   torus %d  0 0 0  0.37 0.014   cylinder %d 0 0 0  0.012 0.76  end\n", first_binding + 3, brass, brass > furniture
    printf "begin -1  1 0 0 5.35  0 0 -1 1.02  0 1 0 -4.1  0 0 0 1  torus %d  0 0 0  0.40 0.018  end\n", wood > furniture
    for (i = 0; i < 3; ++i) printf "cylinder %d  %.4g 0.5 %.4g  0.022 1.0\n", wood, 5.35 + 0.39 * cos(2.094 * i + 0.4), -4.1 + 0.39 * sin(2.094 * i + 0.4) > furniture
  }'
