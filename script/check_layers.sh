#!/bin/sh
# Checks the layers: every #include "..." goes down, or stays in its own layer. Prints each violation.
#   usage: script/check_layers.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"

find R1 R2 R3 source grader rayimg page -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.def' \) ! -path '*/tests/*' | LC_ALL=C sort | xargs awk '
  BEGIN {
    # A layer and those right below it; what is below them is allowed as well.
    below["R1"] = ""
    below["R2"] = "R1"
    below["R3"] = "R2"
    below["text"] = ""
    below["sample"] = "R3"
    below["scene"] = "text sample"
    below["parse"] = "scene"
    below["accelerate"] = "scene"
    below["integrate"] = "accelerate"
    below["film"] = "R2"
    below["render"] = "parse integrate film"
    below["draw"] = "render"
    below["inspect"] = "draw"
    below["view"] = "inspect"
    below["grader"] = "render"
    below["app"] = "view"
    below["rayimg"] = "app grader"
    below["raygrade"] = "app grader"
    below["page"] = "app"
    for (layer in below) allow(layer, layer)
  }

  function allow(layer, lower,   names, count, i) {
    allowed[layer, lower] = 1
    count = split(below[lower], names, " ")
    for (i = 1; i <= count; ++i) allow(layer, names[i])
  }

  function layer_of(path,   parts) {
    split(path, parts, "/")
    if (path ~ /^grader\/raygrade[.\/]/) return "raygrade"
    return parts[1] == "source" ? parts[2] : parts[1]
  }

  function complain(what) {
    printf "%s:%d: %s\n", FILENAME, FNR, what
    ++breaches
  }

  /^[ \t]*#[ \t]*include[ \t]*"/ {
    from = layer_of(FILENAME)
    match($0, /"[^"]*"/)
    path = substr($0, RSTART + 1, RLENGTH - 2)
    to = layer_of(path)
    if (!(from in below)) complain("the folder " from " is not a layer; see docs/code.md")
    else if (!(to in below)) complain("\"" path "\" does not start at the root of the tree")
    else if (!((from, to) in allowed)) complain(from " must not include " to " (\"" path "\")")
  }

  END { if (breaches) { printf "%d includes violate the layers\n", breaches; exit 1 } }
' || exit 1  # xargs has a status of its own
