# A Markdown file as it is installed: a link to a file that is not installed becomes plain text.
#
#     awk -v name=docs/scenes.md -v known=LIST -f script/installed_links.awk docs/scenes.md
#
# LIST is a file with the names of all that is installed beside it, one a line, as links of the tree name them.

BEGIN {
  while ((getline line < known) > 0) is_known[line] = 1
  folder = name
  if (!sub(/\/[^\/]*$/, "", folder)) folder = "."
}

{
  out = ""
  while (match($0, /!?\[[^][]*\]\([^)]*\)/)) {
    link = substr($0, RSTART, RLENGTH)
    out = out substr($0, 1, RSTART - 1) (leads(link) ? link : words(link))
    $0 = substr($0, RSTART + RLENGTH)
  }
  print out $0
}

function words(link) { sub(/^!?\[/, "", link); sub(/\]\([^)]*\)$/, "", link); return link }

function leads(link,   goal) {
  goal = link
  sub(/^.*\]\(/, "", goal)
  sub(/\)$/, "", goal)
  if (goal ~ /^[a-z]+:/) return 1
  sub(/#.*/, "", goal)
  return goal == "" || normal(folder "/" goal) in is_known
}

# A path without "." and "..".
function normal(path,   parts, kept, n, i, depth, result) {
  n = split(path, parts, "/")
  for (i = 1; i <= n; ++i)
    if (parts[i] == "..") --depth
    else if (parts[i] != "." && parts[i] != "") kept[++depth] = parts[i]
  for (i = 1; i <= depth; ++i) result = result (i > 1 ? "/" : "") kept[i]
  return result
}
