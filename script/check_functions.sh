#!/bin/sh
# Checks that elementary functions are our own (R1/Elementary.h): those of the C library give other bits on other
# processors. Those that are exact by definition (sqrt, fma, scalbn, fmod, ...) may be used. Prints each violation.
#   usage: script/check_functions.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"

# Shaders, in source/draw/gl, call functions of the same names.
find R1 R2 R3 source grader rayimg page -type f \( -name '*.h' -o -name '*.cpp' \) ! -path 'source/draw/gl/*' | LC_ALL=C sort | xargs awk '
  BEGIN {
    name = "(sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|" \
           "log1p|pow|cbrt|hypot|erf|erfc|tgamma|lgamma|lgamma_r)[fl]?"
    call = "(^|[^A-Za-z0-9_.>])" name "[ \t]*\\("
    in_raw = 0
  }

  FNR == 1 { in_raw = 0 }

  {
    line = $0
    if (in_raw) { if (line ~ /\)"/) in_raw = 0; next }
    gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
    sub(/\/\/.*/, "", line)
    if (line ~ /R"\($/) in_raw = 1
    if (line ~ call) {
      sub(/^[ \t]*/, "")
      printf "%s:%d: take the function of R1/Elementary.h: %s\n", FILENAME, FNR, $0
      ++breaches
    }
  }

  END { if (breaches) { printf "%d calls of functions of the C library\n", breaches; exit 1 } }
' || exit 1  # xargs has a status of its own
