#!/bin/sh
# Checks the English of comments, messages and names, by a few forms that need translating: a doc comment that opens with
# a question word or a preposition instead of a verb or a noun, "picture" for image, and a few words. Prints each place.
#   usage: script/check_english.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"

# The folders that are clean, each with those below it. Add a folder once it follows.
folders="R1 R2 R3 grader source/text source/sample source/scene source/accelerate source/parse source/film source/integrate source/render source/draw source/inspect source/view source/app rayimg"

# What may stay, as patterns of "file: line".
#   - titles of works
cat > "${TMPDIR:-/tmp}/check_english.$$" <<'ALLOWED'
^R2/image_files/hdr\.cpp: .*"Picture File Format"
^source/film/BlockOrder\.h: .*continuous-tone pictures
ALLOWED
trap 'rm -f "${TMPDIR:-/tmp}/check_english.$$"' EXIT

# shellcheck disable=SC2086 # one word per folder
find $folders -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.def' \) | LC_ALL=C sort | xargs awk '
  BEGIN {
    while ((getline pattern < "'"${TMPDIR:-/tmp}/check_english.$$"'") > 0) allowed[++patterns] = pattern
    question = "^(What|Whether|Where|Which|How|Why|Whose|When|Who)([^A-Za-z]|$)"
    preposition = "^(Of|By|From|In|With|Without|To|For|As|At|On|Into|Beyond|Likewise|Also|Else|Otherwise|Then|So|And|But|" \
                  "Or|It|They|These|Those|That|Such|Same|The same|Not|No|Again)([^A-Za-z]|$)"
    words = "(^|[^A-Za-z])([Tt]ells?|[Tt]old|but for|lest|in words|goes? on|went on|passe[sd] over|" \
            "asks? for|asked for|[Bb]eside|left out)([^A-Za-z]|$)"
    names = "(Tell[A-Z]|InWords|OfEach)"
  }

  function report(fault,   i) {
    for (i = 1; i <= patterns; ++i) if ((FILENAME ": " $0) ~ allowed[i]) return
    printf "%s:%d: %s: %s\n", FILENAME, FNR, fault, text
    ++breaches
  }

  FNR == 1 { before_is_doc = 0 }

  {
    text = $0
    sub(/^[ \t]*/, "", text)
    is_doc = text ~ /^\/\/\//
    if (is_doc && !before_is_doc) {
      opening = text
      sub(/^\/+<?[ \t]*/, "", opening)
      if (opening ~ question) report("a doc comment opens with a question word")
      if (opening ~ preposition) report("a doc comment opens with a preposition or connective")
    }
    before_is_doc = is_doc

    # Literals of a single word may be names that files and command lines have.
    line = $0
    gsub(/"([^" \\]|\\.)*"/, "", line)
    if (line ~ /[Pp]icture/) report("picture instead of image")
    if (line ~ names) report("a name that is no noun or verb")
    comment = line ~ /\/\// ? line : ""
    gsub(/"([^"\\]|\\.)*"/, "", comment)
    sub(/^.*\/\//, "", comment)
    if (comment ~ words) report("a word that needs translating")
  }

  END { if (breaches) { printf "%d places; CONTRIBUTING.md says what to write instead\n", breaches; exit 1 } }
' || exit 1  # xargs has a status of its own
