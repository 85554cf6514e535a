# A surface of revolution as an .obj with the normals of its profile, for `mesh ... smooth`.
#   input     a line a point of the profile, "radius height"; an empty line begins a new stretch, with a crease between.
#             Walked so that the outside lies to the right when it goes up: outer wall up, rim, inner wall down.
#   around    sectors (-v around=48)
#   smooth    how many points a stretch is made into by a Catmull-Rom spline; 0 keeps its own corners (-v smooth=24)
# A radius of 0 closes the surface: its ring is one point.

function spline(a, b, c, d, t) {  # between b and c; Catmull and Rom, A Class of Local Interpolating Splines (1974)
  return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
}
function clamp(i) { return i < 1 ? 1 : i > points ? points : i }

function ring(r, y, nr, ny,   k, angle, sectors) {
  sectors = r > 0 ? around : 1
  for (k = 0; k < sectors; ++k) {
    angle = 2 * pi * k / around
    printf "v %.5g %.5g %.5g\n", r * cos(angle), y, r * sin(angle)
  }
  for (k = 0; k < around; ++k) {
    angle = 2 * pi * k / around
    printf "vn %.4g %.4g %.4g\n", nr * cos(angle), ny, nr * sin(angle)
  }
  first[rings] = vertices; count[rings] = sectors; normal[rings++] = normals
  vertices += sectors; normals += around
}
function corner(n, k) {
  k %= around
  return (first[n] + (count[n] > 1 ? k : 0) + 1) "//" (normal[n] + k + 1)
}
function join(a, b,   k) {  # of two rings
  for (k = 0; k < around; ++k) {
    if (count[a] > 1) print "f", corner(a, k), corner(b, k), corner(a, k + 1)
    if (count[b] > 1) print "f", corner(a, k + 1), corner(b, k), corner(b, k + 1)
  }
}
function stretch(   many, i, p, t, r, y, dr, dy, length_, lr, ly) {
  if (points < 2) { points = 0; return }
  many = smooth > 0 ? smooth : points - 1
  for (i = 0; i <= many; ++i) {
    p = i * (points - 1) / many
    t = p - int(p); p = int(p) + 1
    if (smooth > 0) {
      r = spline(R[clamp(p - 1)], R[clamp(p)], R[clamp(p + 1)], R[clamp(p + 2)], t)
      y = spline(Y[clamp(p - 1)], Y[clamp(p)], Y[clamp(p + 1)], Y[clamp(p + 2)], t)
      if (r < 0) r = 0
    } else { r = R[p]; y = Y[p] }
    xs[i] = r; ys[i] = y
  }
  for (i = 0; i <= many; ++i) {
    dr = xs[i < many ? i + 1 : i] - xs[i > 0 ? i - 1 : i]
    dy = ys[i < many ? i + 1 : i] - ys[i > 0 ? i - 1 : i]
    length_ = sqrt(dr * dr + dy * dy)
    ring(xs[i], ys[i], dy / length_, -dr / length_)
    if (i > 0) join(rings - 2, rings - 1)
  }
  points = 0
}
BEGIN { pi = atan2(0, -1); print "# A surface of revolution, made by script/art/lathe.awk." }
NF == 2 { ++points; R[points] = $1; Y[points] = $2; next }
{ stretch() }
END { stretch() }
