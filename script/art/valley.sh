#!/bin/sh
# Makes art/valley/: mountains around a lake as a mesh with its colors, firs, ripples, and a sky with clouds. The mesh is
# finer near the camera, which stands at x = z = 0 and looks along -z: its columns are rays from there. land.obj has 20 MB
# and is not kept under version control.
# Sources: Perlin, Improving Noise (2002), for how values are blended; Musgrave in Ebert et al., Texturing and Modeling
# (2003), for sums that make ridges.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
rayimg=${RAYIMG:-$here/build/rayimg}
out=$here/art/valley
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"

cat > "$work/land.awk" <<'END'
  function random() { state = (state * 16807) % 2147483647; return state / 2147483647 }
  function prepare(   k) { pi = atan2(0, -1); state = 90210; for (k = 0; k < 4096; ++k) lattice[k] = random() }
  # The value at a lattice point, by two sums of its coordinates mixed, so that no row or column repeats another.
  function value(i, j,   k) {
    k = (i * 7 + 524288) * (j * 3 + 524288) % 1021
    return lattice[((i * 61 + j * 17 + 131072) % 4096 + k) % 4096]
  }
  function blend(t) { return t * t * t * (t * (6 * t - 15) + 10) }
  function floor(x,   i) { i = int(x); return i > x ? i - 1 : i }
  function noise(x, y,   i, j, u, v, a, b) {
    i = floor(x); j = floor(y); u = blend(x - i); v = blend(y - j)
    a = value(i, j); a += (value(i + 1, j) - a) * u
    b = value(i, j + 1); b += (value(i + 1, j + 1) - b) * u
    return a + (b - a) * v
  }
  # A sum of octaves about 0, each turned against the one before.
  function clumps(x, y, octaves,   k, sum, size, t) {
    size = 0.5; sum = 0
    for (k = 0; k < octaves; ++k) {
      sum += (noise(x, y) - 0.5) * size
      size /= 2; t = x; x = 1.6 * x + 1.2 * y + 7.3; y = -1.2 * t + 1.6 * y + 3.1
    }
    return sum
  }
  function step(low, high, x,   t) {
    t = (x - low) / (high - low); t = t < 0 ? 0 : t > 1 ? 1 : t
    return t * t * (3 - 2 * t)
  }
  function ridges(x, y, octaves,   k, sum, weight, size, r, t) {
    weight = 1; size = 0.5; sum = 0
    for (k = 0; k < octaves; ++k) {
      r = noise(x, y); r = 1 - (r < 0.5 ? 1 - 2 * r : 2 * r - 1); r *= r
      sum += r * size * weight
      weight = r * 2.2; if (weight > 1) weight = 1
      size /= 1.92; t = x; x = 1.6 * x + 1.2 * y + 7.3; y = -1.2 * t + 1.6 * y + 3.1
    }
    return sum
  }
  # Above the lake; far is the distance along -z.
  function height(x, far,   side, high, a, b) {
    side = (x - 0.03 * far - 5 * sin(far * 0.045)) / (3.6 + 0.15 * far); if (side < 0) side = -side
    high = 0.62 * step(0.7, 2.1, side) + step(50, 105, far)
    if (high > 1) high = 1
    a = x * 0.022 + 1.3; b = far * 0.022 + 9.1
    if (high > 0) { t = 0.22 * clumps(3 * a + 20, 3 * b, 2); b += 0.22 * clumps(3 * a, 3 * b + 40, 2); a += t }
    return -0.9 + 1.25 * step(0.5, 1.25, side) + 0.35 * noise(x * 0.9, far * 0.9) * step(0.6, 1.2, side) \
      + (high > 0 ? high * step(4, 34, far) * (5 + 0.24 * far) * ridges(a, b, 9) : 0)
  }
  function column(i) { return (2 * i / columns - 1) * 0.66 }
  # A quarter of the rows grow with the distance up to 30, the others are even, for the faces of mountains.
  function distance(j,   t) { t = 4 * j / rows; return t < 1 ? 2.6 * exp(t * log(30 / 2.6)) : 30 + 40 * (t - 1) }
END

cat > "$work/mesh.awk" <<'END'
  BEGIN {
    prepare(); columns = 480; rows = 560
    print "# Mountains around a lake, whose surface is y = 0."
    for (j = 0; j <= rows; ++j)
      for (i = 0; i <= columns; ++i) {
        d = distance(j); x = column(i) * d
        printf "v %.5g %.5g %.5g\nvt %.4f %.4f\n", x, height(x, d), -d, i / columns, j / rows
      }
    for (j = 0; j < rows; ++j)
      for (i = 0; i < columns; ++i) {
        a = j * (columns + 1) + i + 1; b = a + columns + 1
        printf "f %d/%d %d/%d %d/%d %d/%d\n", a, a, a + 1, a + 1, b + 1, b + 1, b, b
      }
  }
END
awk -f "$work/land.awk" -f "$work/mesh.awk" > "$out/land.obj"

# Colors by height and slope: shore, meadow, rock in layers, and snow where it is not too steep; what is far turns to the
# blue of the air. Slopes are differences of neighboring heights.
cat > "$work/colors.awk" <<'END'
  function byte(x) { return x > 255 ? 255 : x }
  function mix(share, red, green, blue) { r += (red - r) * share; g += (green - g) * share; b += (blue - b) * share }
  BEGIN {
    prepare(); columns = 1800; rows = 1600
    print "P3\n" columns, rows "\n255"
    for (j = rows - 1; j >= 0; --j) {
      d = distance(j + 0.5); back = distance(j + 1.5) - d; across = 2 * 0.66 * d / columns
      left = height(column(-0.5) * d, d)
      for (i = 0; i < columns; ++i) {
        x = column(i + 0.5) * d; h = height(x, d)
        hx = (h - left) / across; hz = j < rows - 1 ? (behind[i] - h) / back : 0
        left = h; behind[i] = h
        slope = sqrt(hx * hx + hz * hz)
        fine = clumps(x * 40 / d, 18 * log(d) + 9, 4) * 2; coarse = noise(x * 0.5, d * 0.5) - 0.5
        grass = clumps(x * 3, d * 3, 3)
        r = 84 + 60 * grass; g = 104 + 40 * grass; b = 44 + 20 * grass
        mix(step(0.1, 0.5, coarse + 0.3), 118, 116, 54)
        layer = noise(1.3 * h + 0.4 * x + 3 * fine, 0.12 * x + 0.15 * d) - 0.5 + 1.6 * fine
        mix(step(0.45, 0.8, slope + 0.7 * fine), 98 + 40 * layer, 88 + 38 * layer, 82 + 36 * layer)
        mix(1 - step(0.05, 0.3, h + 0.2 * fine), 150, 136, 104)
        mix(step(7.5, 10.5, h + 5 * coarse + 5 * fine) * (1 - step(1.15, 1.7, slope + 0.8 * fine)), 240, 243, 250)
        shade = 1 + 0.25 * fine
        r *= shade; g *= shade; b *= shade
        mix(0.5 * step(20, 150, d), 168, 186, 214)
        printf "%d %d %d\n", byte(r), byte(g), byte(b)
      }
    }
  }
END
awk -f "$work/land.awk" -f "$work/colors.awk" > "$work/land.ppm"

# Firs on meadows that are neither steep nor high.
cat > "$work/firs.awk" <<'END'
  BEGIN {
    prepare(); state = 4711; columns = 1; rows = 1
    print "# Firs of many sizes."
    for (k = 0; k < 14000; ++k) {
      d = 7 * exp(random() * 2.0); x = (2 * random() - 1) * 0.62 * d; tall = 0.55 + 0.75 * random(); turn = 2 * pi * random()
      h = height(x, d)
      if (h < 0.32 || h > 6 || noise(x * 0.35 + 40, d * 0.35) < 0.50) continue
      hx = height(x + 0.1, d) - h; hz = height(x, d + 0.1) - h
      if (hx * hx + hz * hz > 0.008) continue
      wide = tall * (0.9 + 0.35 * random()); c = wide * cos(turn); s = wide * sin(turn)
      printf "begin -1  %.3g 0 %.3g %.4g  0 %.3g 0 %.4g  %.3g 0 %.3g %.4g  0 0 0 1  include fir%d.scn  end\n", c, s, x,
        tall, h - 0.03, -s, c, -d, 1 + k % 3
    }
  }
END
awk -f "$work/land.awk" -f "$work/firs.awk" > "$out/firs.scn"

# A fir, 1 high: whorls of boughs that hang more the lower they are, each a ridge with two sides cut into twigs.
cat > "$work/fir.awk" <<'END'
  function point(along, aside, drop,   r, y) {  # of a bough of direction c, s
    r = 0.012 + along * reach; y = up - drop * along * along * reach - 0.25 * (aside < 0 ? -aside : aside)
    printf "v %.4f %.4f %.4f\n", r * c - aside * s, y, r * s + aside * c
    return ++points
  }
  BEGIN {
    prepare(); state = seed
    print "# Boughs of a fir, 1 high."
    for (up = 0.13; up < 0.97; up += 0.012 + 0.032 * (1 - up)) {
      boughs = up > 0.8 ? 6 : 9; start = 2 * pi * random()
      for (k = 0; k < boughs; ++k) {
        turn = start + 2 * pi * (k + 0.5 * random()) / boughs; c = cos(turn); s = sin(turn)
        reach = (0.24 * (1 - up) ^ 0.85 + 0.015) * (0.75 + 0.4 * random()); drop = 0.55 + 0.5 * (1 - up)
        root = point(0, 0, drop); twigs = 3
        for (n = 1; n <= twigs; ++n) {
          at = n / twigs; half = 0.16 * reach * (1.25 - at)
          ridge = point(at, 0, drop); left = point(at * 0.93 + 0.05, half, drop); right = point(at * 0.93 + 0.05, -half, drop)
          faces = faces sprintf("f %d %d %d\nf %d %d %d\n", root, right, ridge, root, ridge, left)
          root = point(at * 0.9, 0, drop)
        }
      }
    }
    printf "%s", faces
  }
END
for k in 1 2 3; do
  awk -v seed=$((k * 1009)) -f "$work/land.awk" -f "$work/fir.awk" > "$out/fir$k.obj"
  cat > "$out/fir$k.scn" <<END
# A fir, 1 high.
material  0 0 0  0.030 0.066 0.028  0 0 0  0 0 0  0 0 0  1 1 0
material  0 0 0  0.10 0.07 0.05  0 0 0  0 0 0  0 0 0  1 1 0
cone 1  0 0.5 0  0.022 1
mesh 0 fir$k.obj
END
done

# The sky, latitude by longitude, fine only where it is seen: heaps of cloud in two layers, lit from the left. Elsewhere it
# has the colors of the clear sky, a row of one color each.
cat > "$work/sky.awk" <<'END'
  function cover(u, v,   a) {
    a = 0.5 * clumps(0.6 * v + 3, 0.6 * u, 2)
    return step(-0.04, 0.16, clumps(u + a, v - a, 7) + 0.35 * (noise(0.3 * u + 5, 0.3 * v) - 0.5))
  }
  BEGIN {
    prepare(); width = 6144; high = 3072; west = int(0.4 * width); east = width - west
    print "P3\n" width, high "\n255"
    for (y = 0; y < high; ++y) {
      up = 90 - 180 * (y + 0.5) / high
      glow = exp(-(up < 0 ? -2 * up : up) / 11)
      r = 74 + 156 * glow; g = 116 + 98 * glow; b = 188 + 22 * glow
      clear = sprintf("%d %d %d\n", r + 0.5, g + 0.5, b + 0.5)
      side = clear
      for (x = 1; x * 2 <= west; x *= 2) side = side side
      for (; x < west; ++x) side = side clear
      printf "%s", side
      flat = 1 / (sin((up > 0 ? up : 0) * pi / 180) + 0.09)
      for (x = west; x < east; ++x) {
        cloud = light = 0
        if (up > 0 && up < 45) {
          u = sin(2 * pi * (x / width - 0.5)) * flat * 1.15 + 14; v = cos(2 * pi * (x / width - 0.5)) * flat * 1.15 + 6
          cloud = cover(u, v) * step(0, 5, up) * step(west, west + 250, x) * step(-east, 250 - east, -x) * (1 - step(35, 45, up))
          if (cloud > 0)
            light = 0.88 + 0.4 * (cloud - cover(u - 0.10, v + 0.04)) - 0.16 * cloud * cloud + 0.5 * clumps(2 * u, 3 * v, 4)
        }
        dither = random()
        printf "%d %d %d\n", byte(r + (300 * light - r + 20) * cloud + dither), byte(g + (284 * light - g + 28) * cloud + dither),
          byte(b + (268 * light - b + 44) * cloud + dither)
      }
      printf "%s", side
    }
  }
  function byte(x) { return x > 255 ? 255 : x }
END
awk -f "$work/land.awk" -f "$work/sky.awk" > "$work/sky.ppm"

# Ripples of the water, which repeat: waves that fit in the image a whole number of times.
awk 'BEGIN {
  pi = atan2(0, -1); size = 512; waves = 24; state = 31
  for (k = 0; k < waves; ++k) {
    state = (state * 16807) % 2147483647; i[k] = 2 + state % 23
    state = (state * 16807) % 2147483647; j[k] = state % 9 - 4
    state = (state * 16807) % 2147483647; phase[k] = state % 1000 / 159
    tall[k] = 1 / sqrt(i[k] * i[k] + j[k] * j[k])
  }
  print "P2\n" size, size "\n255"
  for (y = 0; y < size; ++y)
    for (x = 0; x < size; ++x) {
      sum = 0
      for (k = 0; k < waves; ++k) sum += tall[k] * sin(2 * pi * (i[k] * y + j[k] * x) / size + phase[k])
      printf "%d\n", 127.5 + 50 * sum
    }
}' > "$work/ripples.ppm"

# The images keep the command that made them: without a temporary folder in it, their bytes stay the same.
case $rayimg in /*) ;; *) rayimg=$PWD/$rayimg ;; esac
for name in land sky ripples; do
  (cd "$work" && "$rayimg" convert $name.ppm $name.jpg -jpeg_quality 85)
  cp "$work/$name.jpg" "$out/$name.jpg"
done
