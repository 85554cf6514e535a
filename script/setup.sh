#!/bin/sh
# Command 1 of 2: installs what raypro needs, builds it and renders a first image; then the same for rayimg and the
# viewer. A second run installs nothing.
#   script/setup.sh      prints every command that needs administrator rights before running it
#   script/setup.sh -n   dry run: prints what it would do
# Exit status 3: packages are missing and cannot be installed from here; the command that installs them is printed.
set -eu
cd "$(dirname "$0")/.."

only_show=no
case "${1-}" in
  '') ;;
  -n) only_show=yes ;;
  *) echo "usage: script/setup.sh [-n]" >&2; exit 2 ;;
esac

needed="g++ make libjpeg-dev libpng-dev libtbb-dev libhwy-dev nlohmann-json3-dev"
tests="libgtest-dev"
# Without the others everything works but .exr images, .yaml scenes and the viewer. That needs libepoxy, which pulls
# in EGL, and Dear ImGui, which writes in the letters of DejaVu Sans Mono; GLFW opens windows, OSMesa is another way to
# draw without a display; the last two packages are Mesa's software renderer.
formats="libopenexr-dev libyaml-cpp-dev"
viewer="libepoxy-dev libglfw3-dev libosmesa6-dev libimgui-dev fonts-dejavu-core libegl-mesa0 libgl1-mesa-dri"

# A sandbox for the programs that raygrade runs.
grader="bubblewrap"

is_debian() { command -v dpkg-query >/dev/null 2>&1 && command -v apt-get >/dev/null 2>&1; }

is_installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q '^install ok installed$'; }

compiler() { if [ -n "${CXX-}" ]; then echo "$CXX"; else echo g++; fi; }

# Asks the compiler, which also finds what was not installed by the package manager.
has_header() {
  $(compiler) ${CPPFLAGS-} -std=c++20 -include stdio.h -include "$1" -fsyntax-only -x c++ /dev/null >/dev/null 2>&1
}

exr_flags() {
  pkg-config --cflags OpenEXR 2>/dev/null || echo "-isystem /usr/include/OpenEXR -isystem /usr/include/Imath"
}

imgui_flags() { pkg-config --cflags imgui 2>/dev/null || echo "-isystem /usr/include/imgui"; }

# Any vendor's EGL driver will do.
has_driver() { ls /usr/share/glvnd/egl_vendor.d/*.json /etc/glvnd/egl_vendor.d/*.json 2>/dev/null | grep -q .; }

has() {
  case "$1" in
    g++) command -v "$(compiler)" >/dev/null 2>&1 ;;
    make) command -v make >/dev/null 2>&1 ;;
    libjpeg-dev) has_header jpeglib.h ;;
    libpng-dev) has_header png.h ;;
    libtbb-dev) has_header tbb/parallel_for.h ;;
    libhwy-dev) has_header hwy/highway.h ;;
    nlohmann-json3-dev) has_header nlohmann/json.hpp ;;
    libgtest-dev) has_header gtest/gtest.h ;;
    libepoxy-dev) has_header epoxy/egl.h ;;
    libglfw3-dev) (CPPFLAGS="${CPPFLAGS-} -DGLFW_INCLUDE_NONE"; has_header GLFW/glfw3.h) ;;
    libosmesa6-dev) has_header GL/osmesa.h ;;
    libimgui-dev) CPPFLAGS="${CPPFLAGS-} $(imgui_flags)" has_header imgui.h ;;
    fonts-dejavu-core) find /usr/share/fonts -name DejaVuSansMono.ttf 2>/dev/null | grep -q . ;;
    libegl-mesa0|libgl1-mesa-dri) has_driver ;;
    libopenexr-dev) CPPFLAGS="${CPPFLAGS-} $(exr_flags)" has_header ImfOutputFile.h ;;
    libyaml-cpp-dev) has_header yaml-cpp/parser.h ;;
    bubblewrap) command -v bwrap >/dev/null 2>&1 ;;
    *) return 1 ;;
  esac
}

missing_of() {
  for package in "$@"; do
    if is_debian && is_installed "$package"; then continue; fi
    has "$package" || printf ' %s' "$package"
  done
}

show_other_systems() {
  cat <<END
This is not a Debian system. The packages are called:
  Fedora    dnf install gcc-c++ make libjpeg-turbo-devel libpng-devel tbb-devel highway-devel json-devel gtest-devel openexr-devel \\
              yaml-cpp-devel libepoxy-devel glfw-devel mesa-compat-libOSMesa-devel mesa-dri-drivers bubblewrap
  Arch      pacman -S gcc make libjpeg-turbo libpng onetbb highway nlohmann-json gtest openexr yaml-cpp libepoxy glfw imgui mesa bubblewrap
  Homebrew  brew install jpeg-turbo libpng tbb highway nlohmann-json googletest openexr yaml-cpp libepoxy glfw imgui mesa
Install them and run script/setup.sh again.
END
}

show() { echo "+ $*"; }
run_shown() { show "$@"; [ "$only_show" = yes ] || "$@"; }

# The packages that are available: one name unknown to apt would stop all others, and Mesa has dropped OSMesa. None of
# the required ones may be skipped.
available() {
  for package in "$@"; do
    case " $needed $tests " in
      *" $package "*) ;;
      *) apt-cache show "$package" >/dev/null 2>&1 || { echo "$package is not available" >&2; continue; } ;;
    esac
    printf ' %s' "$package"
  done
}

# Fresh systems have no package lists, and old lists name versions that are gone.
install_packages() {
  if [ ! "${lists_are_new-}" ]; then
    run_shown $as_root apt-get update || echo "the package lists could not be updated; using the existing ones"
    lists_are_new=yes
  fi
  [ "$only_show" = yes ] || set -- $(available "$@")
  [ $# -gt 0 ] || return 0
  run_shown $as_root apt-get install -y --no-install-recommends "$@"
}

# Whether this user can install packages on this system; otherwise it prints who can, and how.
can_install() {
  as_root=''
  if ! is_debian; then
    show_other_systems
    return 1
  fi
  [ "$(id -u)" != 0 ] || return 0
  as_root=sudo
  if command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then return 0; fi
  echo "Installing them needs administrator rights. Ask an administrator to run:"
  echo "  apt-get update && apt-get install -y --no-install-recommends $*"
  return 1
}

# Make's output with the files to compile numbered, n of m. Its exit status is that of make.
build() {
  show make -j"$cores" BUILD="$build" "$@"
  [ "$only_show" = no ] || return 0
  # As if nothing were there; less what is.
  total=$(make -n BUILD="$build" "$@" 2>/dev/null | grep -c 'echo "  c++ ') || total=0
  total=$((total - $(find "$build/obj" -name '*.o' 2>/dev/null | wc -l)))
  { make -j"$cores" BUILD="$build" "$@" 2>&1 && echo done; } | awk -v total="$total" '
    $0 == "done" { ended = 1; next }
    $1 == "c++" && ++n <= total { sub(/c\+\+ /, sprintf("c++ %2d of %d ", n, total)) }
    { print; fflush() }
    END { exit !ended }'
}

cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
build=${BUILD:-build}

needed_missing=$(missing_of $needed $tests)
now=$(missing_of $needed $formats)
later=$(missing_of $tests $viewer $grader)
if [ -n "$now$later" ]; then
  echo "missing:$now$later"
  if ! can_install $now $later; then
    [ -z "$needed_missing" ] || exit 3
    echo "They are optional; continuing without them."
    now='' later=''
  fi
fi
[ -z "$now" ] || install_packages $now
build raypro
run_shown "$build/raypro" scenes/hello.scn "$build/sample.jpg" -quiet
[ "$only_show" = yes ] || echo "first image: $build/sample.jpg; now rayimg and the viewer"
[ -z "$later" ] || install_packages $later
build all
# With sudo, what was built belongs to whoever called it, so that make test works without.
[ "$(id -u)" != 0 ] || [ -z "${SUDO_UID-}" ] || run_shown chown -R "$SUDO_UID:${SUDO_GID-}" "$build"
[ "$only_show" = no ] || exit 0
echo "ready. Now try:"
echo "  $build/raypro scenes/first.scn first.png"
[ ! -x "$build/rayview" ] || echo "  $build/rayview scenes/hello.scn"
echo "  make test"
