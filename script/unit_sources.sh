#!/bin/sh
# Prints the .cpp files that a test needs: those beside the headers that it includes, and so on; those without a header
# of their own that include it first; and, for a table (.def) that one includes, the files that define its kinds.
#   usage: script/unit_sources.sh tests/R3/Csg.cpp
set -eu
cd "$(dirname "$0")/.."
[ -f "$1" ] || { echo "there is no test $1" >&2; exit 1; }
find R1 R2 R3 source grader tests -name '*.cpp' -o -name '*.h' -o -name '*.def' | LC_ALL=C sort | awk -v test="$1" '
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
    if (file ~ /\.def$/) need_kinds(file)
  }

  # The .cpp files that define what a table names: of SHAPE(cone), the one that defines cone_kind.
  function need_kinds(table,   folder, i, kinds, count_of) {
    folder = folder_of(table)
    count_of = split(names_in(table), kinds, " ")
    for (i = 1; i <= count_of; ++i) need_definitions_of(kinds[i] "_", folder)
  }

  function names_in(table,   line, names) {
    while ((getline line < table) > 0)
      if (match(line, /^[A-Z_]+\([a-z0-9_]+/)) {
        line = substr(line, 1, RLENGTH)
        sub(/^.*\(/, "", line)
        names = names " " line
      }
    close(table)
    return names
  }

  function need_definitions_of(start, folder,   symbol) {
    for (symbol in defined_in)
      if (index(symbol, start) == 1 && index(defined_in[symbol], folder) == 1) need(defined_in[symbol])
  }

  # without_header[X.h]: the .cpp files of its folder that have no header of their own and include it first of the
  # headers there. defined_in[x]: the .cpp file that defines the constant x for others.
  function look_into_sources(   i, file, line, parts, has_header) {
    for (i = 1; i <= count; ++i) {
      file = files[i]
      if (file !~ /\.cpp$/ || file ~ /^(grader\/)?tests\//) continue
      has_header = (substr(file, 1, length(file) - 4) ".h") in is_file
      while ((getline line < file) > 0) {
        if (!has_header && match(line, /^#include "[^"]*"/)) {
          split(line, parts, "\"")
          if (folder_of(parts[2]) != folder_of(file)) continue
          without_header[parts[2]] = without_header[parts[2]] " " file
          has_header = 1
        }
        if (line ~ /^(extern )?const [A-Za-z]+ [a-z0-9_]+ *[{=]/) {
          sub(/^(extern )?const [A-Za-z]+ /, "", line)
          sub(/ *[{=].*/, "", line)
          defined_in[line] = file
        }
      }
      close(file)
    }
  }

  END {
    look_into_sources()
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
