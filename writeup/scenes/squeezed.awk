# A ball squeezed to a third of its height, as an .obj with normals: right ones (the inverse transpose of the squeeze),
# with normals=wrong those that the squeeze itself makes of the ball's, and with normals=inward right ones turned inside.
#   awk -v normals=right -f writeup/scenes/squeezed.awk > writeup/scenes/squeezed_right.obj
BEGIN {
  rows = 20; columns = 40; s = 1 / 3; pi = atan2(0, -1)
  print "# made by writeup/scenes/squeezed.awk, normals=" normals
  for (i = 0; i <= rows; ++i)
    for (j = 0; j < columns; ++j) {
      y = cos(pi * i / rows); r = sin(pi * i / rows)
      x = r * sin(2 * pi * j / columns); z = r * cos(2 * pi * j / columns)
      printf "v %.4f %.4f %.4f\n", x, s * y, z
      ny = normals == "wrong" ? s * y : y / s
      l = sqrt(x * x + ny * ny + z * z) * (normals == "inward" ? -1 : 1)
      printf "vn %.4f %.4f %.4f\n", x / l, ny / l, z / l
    }
  for (i = 0; i < rows; ++i)
    for (j = 0; j < columns; ++j) {
      a = i * columns + j + 1; b = i * columns + (j + 1) % columns + 1; c = b + columns; d = a + columns
      if (i < rows - 1) face(a, d, c)  # at the poles a square is a triangle
      if (i > 0) face(a, c, b)
    }
}
function face(p, q, r) {
  if (normals == "inward") printf "f %d//%d %d//%d %d//%d\n", p, p, r, r, q, q
  else printf "f %d//%d %d//%d %d//%d\n", p, p, q, q, r, r
}
