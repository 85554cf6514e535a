# Draws a chart with logarithmic axes as SVG, in colors that fit light and dark pages. Reads lines, the fields of which are
# divided by tabs:
#
#     title   text
#     x       text                    below the horizontal axis
#     y       text                    beside the vertical one
#     range   x0 x1 y0 y1             otherwise all points, with some room
#     key     bottom                  where names stand: below at the left instead of above
#     band    text  low  high         the places where y is low to high times x
#     series  text  how  color        how: points, line, steps or labels; color: a number from 1, or 0 for gray
#     NUMBER  NUMBER  [text  [low  high]]   a point of the series, what stands beside it (labels), and its error bar
#
# -v width=480 -v height=400 is the size in pixels. Points outside the range, and those that no logarithm has, are put at
# its edge, so that none is lost.
BEGIN {
  FS = "\t"
  if (!width) width = 480
  if (!height) height = 400
}
$1 == "title" { title = $2; next }
$1 == "x" { label_x = $2; next }
$1 == "y" { label_y = $2; next }
$1 == "range" { x0 = $2; x1 = $3; y0 = $4; y1 = $5; has_range = 1; next }
$1 == "key" { key_is_below = $2 == "bottom"; next }
$1 == "band" { band = $2; band_low = $3; band_high = $4; next }
$1 == "series" { ++series; name[series] = $2; how[series] = $3; color[series] = $4; next }
NF >= 2 && series {
  n = ++points[series]
  px[series, n] = $1 + 0; py[series, n] = $2 + 0; text[series, n] = $3; low[series, n] = $4; high[series, n] = $5
  if ($1 > 0) { if (!least_x || $1 < least_x) least_x = $1 + 0; if ($1 > most_x) most_x = $1 + 0 }
  if ($2 > 0) { if (!least_y || $2 < least_y) least_y = $2 + 0; if ($2 > most_y) most_y = $2 + 0 }
}

function log10(v) { return log(v) / log(10) }
function at_x(v) { return left + (log10(v > x0 ? (v < x1 ? v : x1) : x0) - log10(x0)) / (log10(x1) - log10(x0)) * inner_width }
function at_y(v) { return top + inner_height - (log10(v > y0 ? (v < y1 ? v : y1) : y0) - log10(y0)) / (log10(y1) - log10(y0)) * inner_height }
function escaped(s) { gsub(/&/, "\\&amp;", s); gsub(/</, "\\&lt;", s); gsub(/>/, "\\&gt;", s); return s }
function words(x, y, s, more) { printf "<text x=\"%.1f\" y=\"%.1f\"%s>%s</text>\n", x, y, more, escaped(s) }
function number(v) { return v >= 1e5 || v < 1e-3 ? sprintf("%g", v) : sprintf("%.6g", v) }

# Lines at 1, 2 and 5 times the powers of ten, or at the powers alone where these are many.
function ticks(low, high, is_x,   power, k, v, at, steps, count) {
  count = split(log10(high) - log10(low) > 3.2 ? "1" : "1 2 5", steps, " ")
  for (power = int(log10(low)) - 1; power <= log10(high) + 1; ++power)
    for (k = 1; k <= count; ++k) {
      v = steps[k] * 10 ^ power
      if (v < low * 0.999 || v > high * 1.001) continue
      at = is_x ? at_x(v) : at_y(v)
      if (is_x) {
        printf "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>\n", at, at, top, top + inner_height
        words(at, top + inner_height + 16, number(v), " text-anchor=\"middle\"")
      } else {
        printf "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>\n", left, left + inner_width, at, at
        words(left - 6, at + 4, number(v), " text-anchor=\"end\"")
      }
    }
}

# In steps, since it may leave the frame anywhere.
function draw_band(   k, v, lower, upper) {
  for (k = 0; k <= 50; ++k) {
    v = x0 * (x1 / x0) ^ (k / 50)
    lower = sprintf("%s %.1f,%.1f", lower, at_x(v), at_y(band_low * v))
    upper = sprintf(" %.1f,%.1f%s", at_x(v), at_y(band_high * v), upper)
  }
  printf "<polygon class=\"band\" points=\"%s%s\"/>\n", lower, upper
}

function draw_series(s,   i, path, is_right) {
  for (i = 1; i <= points[s]; ++i) {
    if (high[s, i] != "")
      printf "<line class=\"l%d\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>\n", color[s], at_x(px[s, i]), \
             at_x(px[s, i]), at_y(low[s, i]), at_y(high[s, i])
    if (how[s] == "points")
      printf "<circle class=\"c%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"%s\"/>\n", color[s], at_x(px[s, i]), at_y(py[s, i]), color[s] ? 3.2 : 2
    if (how[s] == "labels") {
      printf "<circle class=\"c%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"4\"/>\n", color[s], at_x(px[s, i]), at_y(py[s, i])
      is_right = at_x(px[s, i]) + 7 * length(text[s, i]) > left + inner_width  # no room there
      words(at_x(px[s, i]) + (is_right ? -6 : 6), at_y(py[s, i]) - 5, text[s, i], is_right ? " text-anchor=\"end\"" : "")
    }
    if (how[s] == "line" || how[s] == "steps") {
      if (how[s] == "steps" && i > 1) path = path sprintf("H%.1f", at_x(px[s, i]))
      path = path sprintf("%s%.1f %.1f", i > 1 ? "L" : "M", at_x(px[s, i]), at_y(py[s, i]))
    }
  }
  if (path) printf "<path class=\"l%d\" d=\"%s\"/>\n", color[s], path
}

function draw_key(   s, y, x, lines) {
  for (s = 1; s <= series; ++s) lines += name[s] != ""
  x = left + 10; y = key_is_below ? top + inner_height - 17 * (lines + (band != "")) + 8 : top + 16
  for (s = 1; s <= series; ++s) {
    if (name[s] == "") continue
    printf "<rect class=\"c%d\" x=\"%.1f\" y=\"%.1f\" width=\"10\" height=\"10\"/>\n", color[s], x, y - 9
    words(x + 16, y, name[s], "")
    y += 17
  }
  if (band != "") {
    printf "<rect class=\"band\" x=\"%.1f\" y=\"%.1f\" width=\"10\" height=\"10\"/>\n", x, y - 9
    words(x + 16, y, band, "")
  }
}

END {
  if (!has_range) { x0 = least_x / 1.3; x1 = most_x * 1.3; y0 = least_y / 1.3; y1 = most_y * 1.3 }
  left = 62; top = title == "" ? 14 : 34; inner_width = width - left - 16; inner_height = height - top - 46
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" role=\"img\">\n", width, height, width, height
  print "<style>text{font:12px sans-serif;fill:#222}.grid{stroke:#ddd}.frame{fill:none;stroke:#888}.back{fill:#fff}"
  print ".band{fill:#7a9;fill-opacity:.25}.c0{fill:#999}.c1{fill:#1f5fbf}.c2{fill:#b85a00}.c3{fill:#157a3c}.c4{fill:#b0282e}"
  print ".l0{stroke:#999}.l1{stroke:#1f5fbf}.l2{stroke:#b85a00}.l3{stroke:#157a3c}.l4{stroke:#b0282e}path{fill:none;stroke-width:2}"
  print "@media(prefers-color-scheme:dark){text{fill:#ddd}.grid{stroke:#444}.back{fill:#1b1b1b}.c0{fill:#777}.c1{fill:#6ea8ff}"
  print ".c2{fill:#f0a050}.c3{fill:#5fc98a}.c4{fill:#ff7b80}.l0{stroke:#777}.l1{stroke:#6ea8ff}.l2{stroke:#f0a050}.l3{stroke:#5fc98a}"
  print ".l4{stroke:#ff7b80}}</style>"
  printf "<rect class=\"back\" width=\"%d\" height=\"%d\"/>\n", width, height
  if (title != "") words(width / 2, 20, title, " text-anchor=\"middle\" font-weight=\"bold\"")
  ticks(x0, x1, 1); ticks(y0, y1, 0)
  if (band != "") draw_band()
  for (s = 1; s <= series; ++s) draw_series(s)
  printf "<rect class=\"frame\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"/>\n", left, top, inner_width, inner_height
  draw_key()
  words(left + inner_width / 2, height - 10, label_x, " text-anchor=\"middle\"")
  printf "<text transform=\"translate(14 %.1f) rotate(-90)\" text-anchor=\"middle\">%s</text>\n", top + inner_height / 2, escaped(label_y)
  print "</svg>"
}
