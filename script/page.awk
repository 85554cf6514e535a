# A page of the writeup, from the table of pictures, what was measured, and a text with lines that begin with @:
#
#     awk -v page=assignment3 -v measured=writeup/measured -f script/page.awk \
#         script/pictures.txt writeup/text/assignment3.html
#
#     @title words               the page's name
#     @section id words          a heading; the list at the top of the page is made of these
#     @pictures section          all pictures of a section of the table
#     @costs id id ... | words   what pictures cost, one row per picture; words say what the table shows
#     @csv file | words          a file of writeup/measured as a table
#     @goals file file ... | words   several of the same columns, one below the other
#     @plot file width height | alt | words
#     @tests | words             the results of the tests of extremes
#
# In other lines {{id.column}} is a number of pictures.csv, and {{tests}}, {{passed}} count the tests of extremes.

BEGIN {
  read_csv("pictures.csv")
  for (i = 2; i <= lines; ++i) for (j = 1; j <= columns; ++j) cost[cell[i, 1], cell[1, j]] = cell[i, j]
  read_csv("extremes.csv")
  for (i = 2; i <= lines; ++i) { ++tests; passed += cell[i, 2] == "passed" }
}

# The table of pictures.
FILENAME ~ /pictures\.txt$/ {
  if (/^#/) next
  if (split($0, f, / *[|] */) < 7) next
  id = f[1]
  order[++count] = id
  section[id] = f[2]; program[id] = f[3]; scene[id] = f[4]; options[id] = f[5]; alt[id] = f[6]; caption[id] = f[7]
  next
}

/^@title / { title = rest(1); next }
/^@section / {
  id = $2
  nav = nav "<li><a href=\"#" id "\">" html(rest(2)) "</a></li>\n"
  put((open_section ? "</section>\n" : "") "<section id=\"" id "\">\n<h2>" html(rest(2)) "</h2>")
  open_section = 1
  next
}
/^@pictures / {
  shown = 0
  for (i = 1; i <= count; ++i) shown += section[order[i]] == $2
  put("<div class=\"pictures" (shown == 1 ? " single" : shown == 5 ? " five" : "") "\">")
  for (i = 1; i <= count; ++i) if (section[order[i]] == $2) show(order[i])
  put("</div>")
  next
}
/^@costs / { costs($0); next }
/^@csv / { csv_table($2, after_bar($0)); next }
/^@goals / { goals($0); next }
/^@plot / {
  split($0, w, / *[|] */)
  put("<figure class=\"plot\"><img src=\"pictures/" $2 "\" width=\"" $3 "\" height=\"" $4 "\" alt=\"" html(w[2]) \
      "\" loading=\"lazy\"><figcaption>" words(w[3]) "</figcaption></figure>")
  next
}
/^@tests/ { test_table(after_bar($0)); next }
/^@/ { print "page.awk: " FILENAME ": unknown line " $0 > "/dev/stderr"; failed = 1; exit 1 }
{
  while (match($0, /\{\{[a-z0-9_.]+\}\}/)) {
    name = substr($0, RSTART + 2, RLENGTH - 4)
    before = substr($0, 1, RSTART - 1)
    after = substr($0, RSTART + RLENGTH)
    $0 = before value(name) after
  }
  put($0)
}

END {
  if (failed) exit 1
  print "<!DOCTYPE html>"
  print "<!-- Made by script/runray.sh from writeup/text/" page ".html, script/pictures.txt and writeup/measured. -->"
  print "<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">"
  print "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
  print "<title>" html(title) "</title>\n<link rel=\"stylesheet\" href=\"style.css\">"
  print "<link rel=\"icon\" href=\"data:,\">"
  print "<script src=\"page.js\" defer></script>\n</head>\n<body>\n<header>\n<h1>" html(title) "</h1>"
  print "<p class=\"pages\">" menu()
  print "<a href=\"../scenes/README.md\">Scenes</a>"
  print "<a href=\"../art/README.md\">Art</a> <a href=\"../README.md\">Readme</a></p>"
  print "</header>\n<nav aria-label=\"Sections\">\n<ul>\n" nav "</ul>\n</nav>\n<main>"
  printf "%s", body
  print (open_section ? "</section>\n" : "") "</main>\n</body>\n</html>"
}

# Links to the pages of the writeup; the one that is shown is marked.
function menu(   pages, n, i, name, links) {
  n = split("assignment3 Assignment,shapes Shapes,light Light,surfaces Surfaces,camera Camera,viewer Viewer," \
            "accuracy Accuracy,courses Other courses,troubleshooting Troubleshooting", pages, ",")
  for (i = 1; i <= n; ++i) {
    name = pages[i]
    sub(/ .*/, "", name); sub(/^[^ ]* /, "", pages[i])
    links = links (i > 1 ? "\n" : "") "<a href=\"" name ".html\"" (name == page ? " aria-current=\"page\"" : "") ">" pages[i] "</a>"
  }
  return links
}

function put(text) { body = body text "\n" }

function rest(n,   text, i) {  # the line behind its first n words
  text = $0
  for (i = 0; i < n; ++i) sub(/^[^ ]+ +/, "", text)
  return text
}

function after_bar(line) { return sub(/^[^|]*[|] */, "", line) ? line : "" }

function html(text) {
  gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); gsub(/>/, "\\&gt;", text); gsub(/"/, "\\&quot;", text)
  return text
}

# Text with `code` in it, and options, which are code as well.
function words(text,   parts, n, i, result) {
  n = split(html(text), parts, "`")
  for (i = 1; i <= n; ++i) result = result (i % 2 ? parts[i] : "<code>" parts[i] "</code>")
  return result
}

function file_of(id) {
  if (program[id] ~ /^text/) return id ".txt"
  return id ((options[id] ~ /-crop/ || options[id] ~ /-mode id/) ? ".png" : ".jpg")
}

function is_viewer(id) { return program[id] == "rayview" || program[id] == "session" }

# Width and height of a picture on the page, as attributes: half of its pixels, five eighths in the viewer, whose letters
# are to be read; all of them where there are few, or panels. What is cut out is shown eight times as large.
function size_of(id,   w, n, i, width, height, share) {
  width = 640
  height = 480
  n = split(options[id], w, " ")
  for (i = 1; i <= n; ++i) {
    if (w[i] == "-width") width = w[i + 1]
    if (w[i] == "-height") height = w[i + 1]
    if (w[i] == "-crop") { width = 8 * (w[i + 3] - w[i + 1]); height = 8 * (w[i + 4] - w[i + 2]) }
  }
  share = options[id] ~ /-crop/ || width < 480 || (is_viewer(id) && options[id] ~ /-width/) ? 1 : is_viewer(id) ? 5 / 8 : 1 / 2
  return "width=\"" width * share "\" height=\"" height * share "\""
}

function image(id, class) {
  if (options[id] ~ /-crop/) class = class (class ? " " : "") "blown"
  return "<img src=\"pictures/" file_of(id) "\" " size_of(id) (class ? " class=\"" class "\"" : "") \
         " alt=\"" html(alt[id]) "\" loading=\"lazy\">"
}

function command_of(id,   file) {
  file = scene[id] ~ /\// ? scene[id] : "scenes/" scene[id] ".scn"
  if (program[id] == "rayview")
    return "build/rayview " file " -headless " size(id, 640, 480) options[id] (options[id] ? " " : "") \
           "-events writeup/views/" id ".events -screenshot " id ".jpg"
  if (program[id] == "session")
    return "script/session.sh writeup/views/" id ".events " file " " id ".avi " options[id]
  if (program[id] == "text") return "build/raypro " file " " size(id, 320, 240) options[id]
  return "build/raypro " file " " file_of(id) " " size(id, 640, 480) options[id]  # the rest is said above the pictures
}

# Lines may end before an option, not after its dash.
function unbroken(command) {
  gsub(/-[a-z_]+( -?[0-9.]+)*/, "<span>&</span>", command)
  return command
}

function size(id, width, height) { return options[id] ~ /-width/ ? "" : "-width " width " -height " height " " }

function seconds_of(id) { return cost[id, "cpu_s"] == "" ? "" : sprintf("%.2f s", cost[id, "cpu_s"]) }

function how(id,   s) {
  s = seconds_of(id)
  return "<code class=\"command\">" unbroken(html(command_of(id))) "</code>" \
         (s ? "<span class=\"cost\">" s ", " grouped(cost[id, "rays"]) " rays</span>" : "")
}

function show(id,   a, b, labels) {
  if (program[id] == "compare") {
    split(scene[id], labels, " "); a = labels[1]; b = labels[2]
    split(options[id], labels, " / ")
    put("<figure id=\"picture-" id "\" class=\"compare\">\n<div class=\"pair\">")
    put("<div class=\"one\">" image(a) "<span class=\"label\">" words(labels[1]) "</span></div>")
    put("<div class=\"two\">" image(b) "<span class=\"label\">" words(labels[2]) "</span></div>\n</div>")
    put("<figcaption>" words(caption[id]) how(a) how(b) "</figcaption>\n</figure>")
  } else if (program[id] == "text") {
    put("<figure id=\"picture-" id "\" class=\"said\"><pre tabindex=\"0\">" html(file_text(measured "/" id ".txt")) "</pre>")
    put("<figcaption>" words(caption[id]) how(id) "</figcaption></figure>")
  } else {
    put("<figure id=\"picture-" id "\">" image(id) "\n<figcaption>" words(caption[id]) how(id) "</figcaption></figure>")
  }
}

function file_text(file,   text, line) {
  while ((getline line < file) > 0) text = text line "\n"
  close(file)
  return text
}

function grouped(n,   text) {  # 1234567 as 1 234 567, with narrow spaces that do not break
  text = sprintf("%d", n)
  while (match(text, /[0-9][0-9][0-9][0-9]+/))
    text = substr(text, 1, RSTART + RLENGTH - 4) "\342\200\257" substr(text, RSTART + RLENGTH - 3)
  return text
}

function value(name,   w) {
  if (name == "tests") return tests
  if (name == "passed") return passed
  split(name, w, ".")
  if (!((w[1], w[2]) in cost)) { print "page.awk: no number " name > "/dev/stderr"; failed = 1 }
  return w[2] ~ /_s$/ ? sprintf("%.2f", cost[w[1], w[2]]) : grouped(cost[w[1], w[2]])
}

function table_start(text) {
  put("<div class=\"scroll\" tabindex=\"0\"><table>" (text ? "<caption>" words(text) "</caption>" : ""))
}

# Long tables are folded away: what they show is said in the line that opens them.
function folded_start(text) {
  put("<details><summary>" words(text) "</summary>")
  table_start("")
}
function folded_end() { put("</tbody></table></div></details>") }

function costs(line,   names, n, i, id, text, rays) {
  text = after_bar(line)
  sub(/ *[|].*/, "", line)
  n = split(line, names, " ")
  table_start(text)
  put("<thead><tr><th>acceleration structure</th><th>seconds</th><th>build</th><th>nodes per ray</th><th>boxes per ray</th>" \
      "<th>primitives per ray</th><th>bytes</th></tr></thead><tbody>")
  for (i = 2; i <= n; ++i) {
    id = names[i]
    rays = cost[id, "rays"]
    if (!rays) { print "page.awk: no costs of " id > "/dev/stderr"; failed = 1; exit 1 }
    put(sprintf("<tr><th>%s</th><td>%.2f</td><td>%.3f</td><td>%.1f</td><td>%.1f</td><td>%.1f</td><td>%s</td></tr>",
                words(caption[id]), cost[id, "cpu_s"], cost[id, "build_s"], cost[id, "nodes"] / rays,
                cost[id, "boxes"] / rays, cost[id, "primitive_tests"] / rays, grouped(cost[id, "bytes"])))
  }
  put("</tbody></table></div>")
}

# Reads measured/file into cell[line, column], lines and columns. Cells may be quoted.
function read_csv(file,   path, line, n, c, text, quoted) {
  path = measured "/" file
  lines = 0
  while ((getline line < path) > 0) {
    ++lines
    n = 1; text = ""; quoted = 0
    while (line != "") {
      c = substr(line, 1, 1); line = substr(line, 2)
      if (c == "\"") quoted = !quoted
      else if (c == "," && !quoted) { cell[lines, n++] = text; text = "" }
      else text = text c
    }
    cell[lines, n] = text
    if (lines == 1) columns = n
  }
  close(path)
}

function rounded(text) {
  if (text !~ /^-?[0-9]*\.[0-9]+(e[-+]?[0-9]+)?$/) return html(text)
  return sprintf("%.3g", text)
}

function row_of(i, tag,   j, text) {
  for (j = 1; j <= columns; ++j)
    text = text "<" tag (cell[i, j] ~ /^-?[0-9.]*(e[-+]?[0-9]+)?$/ ? "" : " class=\"words\"") ">" \
           rounded(tag == "th" ? readable(cell[i, j]) : cell[i, j]) "</" tag ">"
  return "<tr>" text "</tr>"
}

function readable(name) { gsub(/_/, " ", name); return name }

function csv_table(file, text,   i) {
  read_csv(file)
  if (lines < 2) { print "page.awk: nothing is measured in " file > "/dev/stderr"; failed = 1; exit 1 }
  table_start(text)
  put("<thead>" row_of(1, "th") "</thead><tbody>")
  for (i = 2; i <= lines; ++i) put(row_of(i, "td"))
  put("</tbody></table></div>")
}

function goals(line,   names, n, k, i, text) {
  text = after_bar(line)
  sub(/ *[|].*/, "", line)
  n = split(line, names, " ")
  folded_start(text)
  for (k = 2; k <= n; ++k) {
    read_csv(names[k])
    if (k == 2) put("<thead>" row_of(1, "th") "</thead><tbody>")
    for (i = 2; i <= lines; ++i) put(row_of(i, "td"))
  }
  folded_end()
}

# ABoxWithoutThickness as "A box without thickness"; the letters and numbers before it, of families of extremes, are
# left out.
function sentence(name,   text, c, i, is_break) {
  while (match(name, /^[A-Z][0-9]+_/)) name = substr(name, RLENGTH + 1)
  for (i = 1; i <= length(name); ++i) {
    c = substr(name, i, 1)
    is_break = i > 1 && (c ~ /[A-Z]/ || (c ~ /[0-9]/ && substr(name, i - 1, 1) !~ /[0-9]/))
    text = text (is_break ? " " : "") (i > 1 ? tolower(c) : c)
  }
  return text
}

function test_table(text,   i) {
  read_csv("extremes.csv")
  if (!lines) { print "page.awk: nothing is measured in extremes.csv" > "/dev/stderr"; failed = 1; exit 1 }
  folded_start(text)
  put("<thead><tr><th>what the test says</th><th>result</th><th>seconds</th></tr></thead><tbody>")
  for (i = 2; i <= lines; ++i)
    put(sprintf("<tr><th>%s</th><td class=\"words\">%s</td><td>%.2f</td></tr>", html(sentence(cell[i, 1])),
                html(cell[i, 2]), cell[i, 3] / 1000))
  folded_end()
}
