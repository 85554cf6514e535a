#!/bin/sh
# Prints the .cpp files that a test needs: those beside the headers that it includes, and so on; those without a header
# of their own that include it first; and of a table (.def) that one includes, the files of its kinds.
#   usage: script/unit_sources.sh tests/R3/Csg.cpp
set -eu
cd "$(dirname "$0")/.."
[ -f "$1" ] || { echo "there is no test $1" >&2; exit 1; }
find R1 R2 R3 source tests -name '*.cpp' -o -name '*.h' -o -name '*.def' | LC_ALL=C sort | awk -v test="$1" '
  { is_file[$0] = 1; files[++count] = $0 }

  function folder_of(file) { sub(/[^\/]*$/, "", file); return file }

  function need(file,   i, parts, count_of) {
    if (!(file in is_file) || file in is_needed) return
    is_needed[file] = 1
    queue[++last] = file
    if (file ~ /\.h$/) {
      need(substr(file, 1, length(file) - 2) ".cpp")
      count_of = split(without_header[file], parts, " ")
      for (i = 1; i <= count_of; ++i) need(parts[i])
    }
    if (file ~ /\.def$/) need_kinds(substr(file, 1, length(file) - 4))
  }

  # The kinds of shapes.def are in shapes/, those of commands.def beside it.
  function need_kinds(table,   folder, i, has_folder) {
    for (i = 1; i <= count; ++i) if (index(files[i], table "/") == 1) has_folder = 1
    folder = table "/"
    if (!has_folder) sub(/[^\/]*\/$/, "", folder)
    for (i = 1; i <= count; ++i)
      if (index(files[i], folder) == 1 && files[i] ~ /\.cpp$/ && substr(files[i], length(folder) + 1) !~ /\//) need(files[i])
  }

  # without_header[X.h]: the .cpp files of its folder that have no header of their own and include it
  # first of the headers there.
  function find_those_without_header(   i, file, line, parts) {
    for (i = 1; i <= count; ++i) {
      file = files[i]
      if (file !~ /\.cpp$/ || file ~ /^tests\// || (substr(file, 1, length(file) - 4) ".h") in is_file) continue
      while ((getline line < file) > 0)
        if (match(line, /^#include "[^"]*"/)) {
          split(line, parts, "\"")
          if (folder_of(parts[2]) != folder_of(file)) continue
          without_header[parts[2]] = without_header[parts[2]] " " file
          break
        }
      close(file)
    }
  }

  END {
    find_those_without_header()
    need(test)
    need("tests/Main.cpp")
    for (first = 1; first <= last; ++first) {
      while ((getline line < queue[first]) > 0)
        if (match(line, /^[ \t]*#[ \t]*include[ \t]*"[^"]*"/)) {
          split(line, parts, "\"")
          need(parts[2])
        }
      close(queue[first])
    }
    for (file in is_needed) if (file ~ /\.cpp$/) print file
  }' | LC_ALL=C sort
