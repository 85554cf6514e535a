#!/bin/bash
# Odd places, habits and machines, a line each; README.md beside this file lists them. What cannot be tried says why.
#   usage: tests/fresh/matrix.sh FOLDER [CELL...]      FOLDER: new or empty; about 1 GB while it runs
#   TESTS="tests/..."   which tests are compiled and run; those of the programs unless given
#   SEED=build          objects to begin with, when they were made from this very commit; saves most of the time
#   KEEP=1              leaves FOLDER as it is at the end
set -u
tree=$(cd "$(dirname "$0")/../.." && pwd)
[ $# -ge 1 ] || { sed -n 3,7p "$0" >&2; exit 2; }
mkdir -p "$1" && folder=$(cd "$1" && pwd)
[ -n "${AGAIN-}" ] || [ -z "$(ls -A "$folder")" ] || { echo "$folder is not empty" >&2; exit 2; }
shift
wanted=" $* "
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
tests=${TESTS:-tests/Main.cpp $(cd "$tree" && echo tests/source/app/*.cpp tests/bad_scenes/*.cpp)}
failures=0

has_picture() { [ -s "$1" ]; }
fails() { if "$@"; then return 1; fi; }  # "! command" would not end a cell

only_what_is_needed=(HAS_EXR=no HAS_YAML=no CONTEXTS= OPTIMIZE=-O0 CXXFLAGS=-Werror)

# A cell is a function; it fails by its status, and says "not possible: why" when this machine cannot try it.
cell() {  # name, function
  [ "$wanted" = "  " ] || [[ $wanted == *" $2 "* ]] || return 0
  local log=$folder/$2.log start=$SECONDS result=ok
  ( set -eu; "$2" ) >"$log" 2>&1 </dev/null  # not behind "||", which would switch off -e within
  [ $? = 0 ] || result=FAILED
  local why
  why=$(sed -n 's/^not possible: //p' "$log" | tail -1)
  if [ -n "$why" ]; then result="not possible: $why"; fi
  if [ "$result" = FAILED ]; then
    failures=$((failures + 1))
    echo "$1: FAILED, $((SECONDS - start)) s; the end of $log:"
    tail -15 "$log" | sed 's/^/    /'
  else
    echo "$1: $result, $((SECONDS - start)) s$(sed -n 's/^remark: /; /p' "$log" | tr -d '\n')"
  fi
}
cannot() { echo "not possible: $*"; exit 0; }
remark() { echo "remark: $*"; }

full="$folder/Szenen & Übungen – 光/raypro"  # blanks, an ampersand and three scripts
core=$folder/core
elsewhere=$folder/elsewhere

unpack() { mkdir -p "$1" && git -C "$tree" archive HEAD | tar -C "$1" -xf -; }
# The command 2 of the README with the tests of this matrix; the log tells what was skipped.
run_tests() {
  make -j"$jobs" TEST_SOURCES="$tests" test "$@" > "$folder/tests.log" 2>&1 || { cat "$folder/tests.log"; exit 1; }
  fails grep -n 'warning:' "$folder/tests.log"
  remark "$(grep -E '^[0-9]+ passed' "$folder/tests.log" | tail -1)"
}
render() { "$1" "$2/scenes/hello.scn" "$3" -width 48 -height 48 -quiet; }

path_with_blanks() {
  unpack "$full"
  cd "$full"
  if [ -n "${SEED-}" ]; then
    mkdir -p build/obj
    cp -R "$tree/$SEED/obj/R1" "$tree/$SEED/obj/R2" "$tree/$SEED/obj/R3" "$tree/$SEED/obj/source" build/obj/
    cp "$tree/$SEED/flags" "$tree/$SEED/features" build/
    find build -exec touch {} +
  fi
  script/setup.sh 2>&1 | tee "$folder/setup.log"  # all packages are in: it only builds
  fails grep -n 'warning:' "$folder/setup.log"
  has_picture build/sample.jpg
  run_tests
  grep -q "\"directory\":\"$full\"" build/compile_commands.json
}

openexr() {
  cd "$full"
  build/raypro -version | grep -q exr=yes || cannot "OpenEXR is not installed"
  build/raypro scenes/hello.scn "$folder/hello.exr" -layers depth -width 32 -height 32 -quiet
  build/rayimg info "$folder/hello.exr"
}

viewer_without_display() {
  cd "$full"
  [ -x build/rayview ] || cannot "nothing to draw with is installed"
  local drew=
  for context in egl osmesa; do
    if ! build/raypro -version | grep -q "rayview=.*$context"; then remark "$context is not built in"; continue; fi
    env -u DISPLAY -u WAYLAND_DISPLAY build/rayview scenes/hello.scn -headless -context $context -exit_immediately \
      -output_image "$folder/$context.png" -width 64 -height 64 -quiet
    has_picture "$folder/$context.png"
    drew="$drew $context"
  done
  [ -n "$drew" ]
  remark "drew by$drew"
}

viewer_with_xvfb() {
  cd "$full"
  build/raypro -version | grep -q 'rayview=glfw' || cannot "GLFW is not installed"
  command -v xvfb-run >/dev/null || cannot "xvfb-run is not installed"
  xvfb-run -a build/rayview scenes/hello.scn -exit_immediately -output_image "$folder/window.png" -quiet
  has_picture "$folder/window.png"
}

without_network() {
  cd "$full"
  unshare -n true 2>/dev/null || cannot "unshare -n needs root"
  unshare -n script/setup.sh > "$folder/offline.log" 2>&1 || { cat "$folder/offline.log"; exit 1; }
  fails grep -n apt-get "$folder/offline.log"
  unshare -n make -j"$jobs" TEST_SOURCES="$tests" test GTEST='--gtest_filter=Raypro*:Rayimg*:Rayview*'
}

# Everything that the programs print, but times.
all_outputs() {
  build/raypro -help; build/raypro -man; build/raypro -man scn; build/raypro -list
  build/raypro scenes/hello.scn -check -threads 1
  build/raypro scenes/hello.scn -debugpixel 20 30
  for kind in ppm pfm hdr; do
    render build/raypro . "$folder/out.$kind"
    cksum < "$folder/out.$kind"
  done
  build/raypro scenes/hello.scn "$folder/out.png" -error 2.5 -aperture 0.25 -focus 7.5 -report "$folder/out.json" \
    -width 24 -height 24 -quiet
  build/rayimg convert "$folder/out.hdr" "$folder/half.png" -exposure 0.5
  build/rayimg diff "$folder/out.hdr" "$folder/out.pfm" -json
  build/rayimg info "$folder/out.hdr" "$folder/half.png"
  build/raypro -info "$folder/out.png" | grep -v '^seconds:'
  sed -E 's/[0-9.e+-]+/0/g' "$folder/out.json"
}
# A locale with commas; made here where the system has its sources and not the thing itself.
german() {
  if locale -a 2>/dev/null | grep -qi '^de_DE.utf-\?8$'; then return 0; fi
  command -v localedef >/dev/null && mkdir -p "$folder/locales" &&
    localedef -i de_DE -f UTF-8 "$folder/locales/de_DE.UTF-8" >/dev/null 2>&1 || cannot "there is no locale de_DE.UTF-8"
  export LOCPATH=$folder/locales
}
german_locale() {
  cd "$full"
  german
  [ "$(LC_ALL=de_DE.UTF-8 /usr/bin/printf '%.1f' 1,5)" = 1,5 ] || cannot "the locale has no effect"
  LC_ALL=C all_outputs > "$folder/outputs.C" 2>&1
  LC_ALL=de_DE.UTF-8 all_outputs > "$folder/outputs.de" 2>&1
  diff "$folder/outputs.C" "$folder/outputs.de"
  LC_ALL=de_DE.UTF-8 run_tests
}

posixly_correct() {
  cd "$full"
  export POSIXLY_CORRECT=1
  script/setup.sh
  run_tests
  sh tests/fresh/install.sh build
}

umask_077() {
  cd "$full"
  umask 077
  sh tests/fresh/install.sh build
  render build/raypro . "$folder/private.ppm"
}

one_core() {
  cd "$full"
  command -v taskset >/dev/null || cannot "taskset is not installed"
  render build/raypro . "$folder/many.ppm"
  taskset -c 0 build/raypro scenes/hello.scn "$folder/one.ppm" -width 48 -height 48 -quiet
  cmp "$folder/many.ppm" "$folder/one.ppm"
  taskset -c 0 make TEST_SOURCES="$tests" test GTEST='--gtest_filter=*Commands*runs:Extremes*:Progress*'
}

install_and_uninstall() {
  cd "$full"
  make -s installcheck
}

# In a copy, over the objects of the build before.
contributing() {
  # With its times, by which make knows what is built already.
  if [ -d "$core" ]; then cp -pR "$core" "$folder/disc"; else unpack "$folder/disc"; fi
  cd "$folder/disc"
  sed -n '/^```cpp$/,/^```$/p' CONTRIBUTING.md | sed '1d;$d' > R3/shapes/disc.cpp
  echo 'SHAPE(disc)' >> R3/shapes.def
  make -j"$jobs" BUILD="$elsewhere" "${only_what_is_needed[@]}" TEST_SOURCES="tests/Main.cpp tests/every/Shapes.cpp" \
    raypro test-binary
  "$elsewhere/raytests"
  sed -n '/^camera /,/^```/p' CONTRIBUTING.md | sed '$d' > disc.scn
  "$elsewhere/raypro" disc.scn "$folder/disc.png" -quiet
  has_picture "$folder/disc.png"
}

# Two in one build, since it is a whole one: only what is needed, and sources that nobody can write to.
core_from_read_only_source() {
  unpack "$core"
  local before
  before=$(cd "$core" && find . | LC_ALL=C sort | cksum)
  if [ "$(id -u)" = 0 ]; then
    if mount --bind "$core" "$core" 2>/dev/null && mount -o remount,bind,ro "$core"; then
      trap 'cd /; umount "$core"' EXIT
    else
      remark "root may write anywhere and cannot mount here: what was written is looked for instead"
    fi
  else
    chmod -R a-w "$core"
    trap 'chmod -R u+w "$core"' EXIT
  fi
  cd "$core"
  make -j"$jobs" BUILD="$elsewhere" "${only_what_is_needed[@]}"
  [ ! -e "$elsewhere/rayview" ]
  run_tests BUILD="$elsewhere" "${only_what_is_needed[@]}"
  [ "$before" = "$(find . | LC_ALL=C sort | cksum)" ]
  # Nothing of the viewer's was read, and nothing of it is linked.
  find "$elsewhere/obj" -name '*.d' -exec cat {} + > "$folder/read"
  fails grep -E '/(GL|EGL|KHR|epoxy|GLFW|OpenEXR|Imath|yaml-cpp|imgui)/' "$folder/read"
  ldd "$elsewhere/raypro" "$elsewhere/rayimg" "$elsewhere/raytests" > "$folder/linked"
  fails grep -E 'libGL|libEGL|libepoxy|OSMesa|glfw|OpenEXR|yaml-cpp' "$folder/linked"
  "$elsewhere/raypro" -version
  local status=0
  "$elsewhere/raypro" scenes/hello.scn "$folder/no.exr" || status=$?
  [ "$status" = 2 ]
  render "$elsewhere/raypro" . "$folder/core.ppm"
  # The same picture as with everything built in, and with optimization.
  [ -x "$full/build/raypro" ] || return 0
  render "$full/build/raypro" . "$folder/full.ppm"
  cmp "$folder/core.ppm" "$folder/full.ppm"
}

archive() { sh "$tree/script/check_dist.sh" ${DIST-}; }

main() {  # read whole before it runs: editing this file meanwhile does no harm
  cell "everything that is here, in a path with blanks and beyond ASCII" path_with_blanks
  cell "OpenEXR" openexr
  cell "viewer without a display" viewer_without_display
  cell "viewer with xvfb" viewer_with_xvfb
  cell "without network" without_network
  cell "LC_ALL=de_DE.UTF-8" german_locale
  cell "POSIXLY_CORRECT=1" posixly_correct
  cell "umask 077" umask_077
  cell "one core" one_core
  cell "install and uninstall" install_and_uninstall
  cell "core only, from a source that is read-only, built elsewhere" core_from_read_only_source
  cell "the shape of CONTRIBUTING.md" contributing
  cell "make dist" archive

  [ -n "${KEEP-}" ] || [ "$failures" != 0 ] || rm -rf "$folder"
  [ "$failures" = 0 ] || { echo "$failures failed; $folder is kept"; exit 1; }
  exit 0
}
main
