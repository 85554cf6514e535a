#!/bin/sh
# Command 1 of 2: installs what is missing, builds, and renders a first picture. A second run installs nothing.
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

needed="g++ make libjpeg-dev libpng-dev libtbb-dev libhwy-dev nlohmann-json3-dev libgtest-dev"
# Without them everything works but .exr pictures, .yaml scenes and the viewer. That needs libepoxy, which brings EGL;
# GLFW opens windows, OSMesa is another way to draw without a display, and the last two packages are Mesa's software
# renderer.
optional="libopenexr-dev libyaml-cpp-dev libepoxy-dev libglfw3-dev libosmesa6-dev libegl-mesa0 libgl1-mesa-dri"

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
    libegl-mesa0|libgl1-mesa-dri) has_driver ;;
    libopenexr-dev) CPPFLAGS="${CPPFLAGS-} $(exr_flags)" has_header ImfOutputFile.h ;;
    libyaml-cpp-dev) has_header yaml-cpp/parser.h ;;
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
              yaml-cpp-devel libepoxy-devel glfw-devel mesa-compat-libOSMesa-devel mesa-dri-drivers
  Arch      pacman -S gcc make libjpeg-turbo libpng onetbb highway nlohmann-json gtest openexr yaml-cpp libepoxy glfw mesa
  Homebrew  brew install jpeg-turbo libpng tbb highway nlohmann-json googletest openexr yaml-cpp libepoxy glfw mesa
Install them and run script/setup.sh again.
END
}

run_shown() { echo "+ $*"; [ "$only_show" = yes ] || "$@"; }

# The packages that are available: one name unknown to apt would stop all others, and Mesa has dropped OSMesa. None of
# the required ones may be skipped.
available() {
  for package in "$@"; do
    case " $needed " in
      *" $package "*) ;;
      *) apt-cache show "$package" >/dev/null 2>&1 || { echo "$package is not available" >&2; continue; } ;;
    esac
    printf ' %s' "$package"
  done
}

# Fresh systems have no package lists, and old lists name versions that are gone.
install_packages() {
  as_root=$1; shift
  run_shown $as_root apt-get update || echo "the package lists could not be updated; using the existing ones"
  [ "$only_show" = yes ] || set -- $(available "$@")
  [ $# -gt 0 ] || return 0
  run_shown $as_root apt-get install -y --no-install-recommends "$@"
}

# False when this system or this user cannot install packages; then it prints who can, and how.
try_to_install() {
  if ! is_debian; then
    show_other_systems
    return 1
  fi
  if [ "$(id -u)" = 0 ]; then
    install_packages "" "$@"
  elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    install_packages sudo "$@"
  else
    echo "Installing them needs administrator rights. Ask an administrator to run:"
    echo "  apt-get update && apt-get install -y --no-install-recommends $*"
    return 1
  fi
}

missing_needed=$(missing_of $needed)
missing=$missing_needed$(missing_of $optional)
if [ -n "$missing" ]; then
  echo "missing:$missing"
  if ! try_to_install $missing; then
    [ -z "$missing_needed" ] || exit 3
    echo "They are optional; continuing without them."
  fi
fi

cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
build=${BUILD:-build}
run_shown make -j"$cores" BUILD="$build"
run_shown "$build/raypro" scenes/hello.scn "$build/sample.jpg" -width 512 -height 512 -quiet
[ "$only_show" = yes ] || echo "first picture: $build/sample.jpg"
