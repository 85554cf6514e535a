#!/bin/sh
# Makes art/valley/: mountains around a lake as a mesh with its colors, firs, and a sky with clouds. The mesh is finer near
# the camera, which stands at x = z = 0 and looks along -z: its columns are rays from there.
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
  # Of a lattice point: two sums of its coordinates mixed, so that no row or column repeats another.
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
  function step(low, high, x,   t) {
    t = (x - low) / (high - low); t = t < 0 ? 0 : t > 1 ? 1 : t
    return t * t * (3 - 2 * t)
  }
  function ridges(x, y, octaves,   k, sum, weight, size, r) {
    weight = 1; size = 0.5; sum = 0
    for (k = 0; k < octaves; ++k) {
      r = noise(x, y); r = 1 - (r < 0.5 ? 1 - 2 * r : 2 * r - 1); r *= r
      sum += r * size * weight
      weight = r * 1.6; if (weight > 1) weight = 1
      size /= 2; t = x; x = 1.6 * x + 1.2 * y + 7.3; y = -1.2 * t + 1.6 * y + 3.1
    }
    return sum
  }
  # Above the lake; far is the distance along -z.
  function height(x, far,   side, high) {
    side = (x - 0.03 * far - 5 * sin(far * 0.045)) / (3.6 + 0.15 * far); if (side < 0) side = -side
    high = 0.62 * step(0.7, 2.1, side) + step(50, 105, far)
    if (high > 1) high = 1
    return -0.9 + 1.25 * step(0.5, 1.25, side) + 0.35 * noise(x * 0.9, far * 0.9) * step(0.6, 1.2, side) \
      + high * step(4, 34, far) * (5 + 0.24 * far) * ridges(x * 0.022 + 1.3, far * 0.022 + 9.1, 7)
  }
  function column(i) { return (2 * i / columns - 1) * 0.66 }
  # A quarter of the rows grow with the distance up to 30, the others are even, for the faces of mountains.
  function distance(j,   t) { t = 4 * j / rows; return t < 1 ? 2.6 * exp(t * log(30 / 2.6)) : 30 + 40 * (t - 1) }
END

cat > "$work/mesh.awk" <<'END'
  BEGIN {
    prepare(); columns = 160; rows = 150
    print "# Mountains around a lake, whose surface is y = 0."
    for (j = 0; j <= rows; ++j)
      for (i = 0; i <= columns; ++i) {
        d = distance(j); x = column(i) * d; e = 0.004 * d
        h = height(x, d)
        nx = height(x - e, d) - height(x + e, d); nz = height(x, d + e) - height(x, d - e)
        l = sqrt(nx * nx + nz * nz + 4 * e * e)
        printf "v %.4g %.4g %.4g\nvn %.2f %.2f %.2f\nvt %.4f %.4f\n", x, h, -d, nx / l, 2 * e / l, nz / l, i / columns, j / rows
      }
    for (j = 0; j < rows; ++j)
      for (i = 0; i < columns; ++i) {
        a = j * (columns + 1) + i + 1; b = a + columns + 1
        printf "f %d/%d/%d %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, a + 1, a + 1, a + 1, b + 1, b + 1, b + 1, b, b, b
      }
  }
END
awk -f "$work/land.awk" -f "$work/mesh.awk" > "$out/land.obj"

# Colors by height and slope: shore, meadow, rock and snow; what is far turns to the blue of the air.
cat > "$work/colors.awk" <<'END'
  function byte(x) { return x > 255 ? 255 : x }
  function mix(share, red, green, blue) { r += (red - r) * share; g += (green - g) * share; b += (blue - b) * share }
  BEGIN {
    prepare(); columns = 1200; rows = 800
    print "P3\n" columns, rows "\n255"
    for (j = rows - 1; j >= 0; --j)
      for (i = 0; i < columns; ++i) {
        d = distance(j + 0.5); x = column(i + 0.5) * d; e = 0.006 * d
        h = height(x, d); hx = (height(x + e, d) - h) / e; hz = (height(x, d + e) - h) / e
        slope = sqrt(hx * hx + hz * hz); fine = noise(x * 60 / d, 25 * log(d) + 9) - 0.5; coarse = noise(x * 0.5, d * 0.5) - 0.5
        r = 92; g = 112; b = 48
        mix(step(0.1, 0.5, coarse + 0.3), 122, 120, 52)
        mix(step(0.5, 0.95, slope + 0.5 * fine), 118, 106, 96)
        mix(1 - step(0.05, 0.3, h + 0.2 * fine), 150, 136, 104)
        mix(step(8, 12, h + 5 * coarse + 2 * fine) * (1 - step(1.2, 2.0, slope + 0.6 * fine)), 242, 244, 250)
        shade = 1 + 0.35 * fine
        r *= shade; g *= shade; b *= shade
        mix(0.55 * step(20, 150, d), 168, 186, 214)
        printf "%d %d %d\n", byte(r), byte(g), byte(b)
      }
  }
END
awk -f "$work/land.awk" -f "$work/colors.awk" > "$work/land.ppm"

# Firs on meadows that are neither steep nor high.
cat > "$work/firs.awk" <<'END'
  BEGIN {
    prepare(); state = 4711; columns = 1; rows = 1
    print "# Firs of many sizes."
    for (k = 0; k < 9000; ++k) {
      d = 7 * exp(random() * 2.0); x = (2 * random() - 1) * 0.62 * d; tall = (0.7 + 0.6 * random()); turn = 2 * pi * random()
      h = height(x, d)
      if (h < 0.32 || h > 6 || noise(x * 0.35 + 40, d * 0.35) < 0.52) continue
      hx = height(x + 0.1, d) - h; hz = height(x, d + 0.1) - h
      if (hx * hx + hz * hz > 0.008) continue
      printf "begin -1  %.3g 0 0 %.4g  0 %.3g 0 %.4g  0 0 %.3g %.4g  0 0 0 1  include fir.scn  end\n", 0.9 * tall, x,
        tall, h - 0.03, 0.9 * tall, -d
    }
  }
END
awk -f "$work/land.awk" -f "$work/firs.awk" > "$out/firs.scn"
cat > "$out/fir.scn" <<'END'
# A fir, 1 high.
material  0 0 0  0.035 0.07 0.03  0 0 0  0 0 0  0 0 0  1 1 0
material  0 0 0  0.10 0.07 0.05  0 0 0  0 0 0  0 0 0  1 1 0
cylinder 1  0 0.1 0  0.03 0.2
cone 0  0 0.34 0  0.22 0.44
cone 0  0 0.55 0  0.17 0.42
cone 0  0 0.77 0  0.11 0.46
END

# The sky, latitude by longitude: clouds in sheets, seen from below, so that they close up towards the horizon.
cat > "$work/sky.awk" <<'END'
  BEGIN {
    prepare(); width = 2048; high = 1024
    print "P3\n" width, high "\n255"
    for (y = 0; y < high; ++y) {
      up = 90 - 180 * (y + 0.5) / high
      glow = exp(-(up < 0 ? -2 * up : up) / 12)
      r = 88 + 150 * glow; g = 128 + 92 * glow; b = 196 + 10 * glow
      flat = 1 / (sin((up > 0 ? up : 0) * pi / 180) + 0.07)
      for (x = 0; x < width; ++x) {
        cloud = 0
        if (up > 0 && up < 60 && x > 0.33 * width && x < 0.67 * width) {
          u = sin(2 * pi * (x / width - 0.5)) * flat * 1.3; v = cos(2 * pi * (x / width - 0.5)) * flat * 1.3
          cloud = 0.6 * noise(u, v) + 0.25 * noise(2 * u + 9, 2.1 * v) + 0.15 * noise(4.2 * u, 4.1 * v + 5)
          cloud = step(0.47, 0.72, cloud) * step(0, 6, up) * step(0.33, 0.4, x / width) * step(-0.67, -0.6, -x / width)
        }
        printf "%d %d %d\n", r + (250 - r) * 0.85 * cloud, g + (234 - g) * 0.85 * cloud, b + (222 - b) * 0.85 * cloud
      }
    }
  }
END
awk -f "$work/land.awk" -f "$work/sky.awk" > "$work/sky.ppm"
for name in land sky; do (cd "$work" && "$rayimg" convert $name.ppm $name.jpg -jpeg_quality 95); done
cp "$work/land.jpg" "$work/sky.jpg" "$out"
