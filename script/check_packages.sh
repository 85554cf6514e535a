#!/bin/sh
# Checks that all who name packages name the same: script/setup.sh, which installs them, debian/control, the table of
# docs/building.md, the Containerfile and make/features.mk. Prints each difference.
#   usage: script/check_packages.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"

# The words of a text, in one line.
words() { tr -s ' \n' '  '; }

# What a variable of script/setup.sh is set to.
of_setup() { sed -n "s/^$1=\"\(.*\)\"\$/\1/p" script/setup.sh; }

# What script/setup.sh tells users of another system to install: all that follows the command on its line, and on the
# next where that line goes on.
of_other_system() {
  sed -n "/^  $1 /{ /\\\\\$/{ N; s/\\\\*\n//; }; s/^  $1  *[a-z]* [-a-zA-Z]* //p; }" script/setup.sh
}

# The packages of a row of the table, required and optional.
of_docs() { grep "^| $1" docs/building.md | cut -d'|' -f3 | sed 's/; optional//' | tr '`' ' '; }

failed=0
# requires WHO LIST OTHER OTHERS: every package of the list is among those that the other names.
requires() {
  for package in $2; do
    case " $4 " in
      *" $package "*) ;;
      *) echo "$1 names $package, $3 does not"; failed=1 ;;
    esac
  done
}
compare() {
  requires "$1" "$2" "$3" "$4"
  requires "$3" "$4" "$1" "$2"
}

all="$(of_setup needed) $(of_setup tests) $(of_setup formats) $(of_setup viewer)"
# What runs beside is no matter of building.
compare script/setup.sh "$(echo "$all $(of_setup grader)" | words)" "docs/building.md (Debian)" "$(of_docs Debian | words)"
for system in Fedora Arch Homebrew; do
  compare "script/setup.sh ($system)" "$(of_other_system $system | words)" docs/building.md "$(of_docs $system | words)"
done

# The compiler and make are there wherever Debian packages are built, and debhelper is for packages alone.
build_depends=$(sed -n '/^Build-Depends:/,/^[^ ]*: /{ s/^Build-Depends://; /^[A-Z]/d; p; }' debian/control |
  sed 's/<!nocheck>//g; s/([^)]*)//g; s/,/ /g')
compare script/setup.sh "$(echo "$all" | tr ' ' '\n' | grep -v -x -e 'g++' -e make | words)" \
  debian/control "$(echo "$build_depends" | tr ' ' '\n' | grep -v -x debhelper-compat | words)"

# What runs needs the libraries, whose names hold versions, and all else that is no development package.
requires script/setup.sh "$(of_setup viewer | tr ' ' '\n' | grep -v -e '-dev$' | words)" \
  "the Containerfile" "$(tr -c 'a-z0-9.-' '\n' < Containerfile | words)"

# What a build without them advises to install.
requires make/features.mk "$(grep -o '[-a-z0-9]*-dev' make/features.mk | words)" script/setup.sh "$all"
exit $failed
