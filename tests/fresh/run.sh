#!/bin/sh
# The two commands in a bare system; see README.md beside this file.
set -eu

if [ $# != 1 ] || [ "$(id -u)" != 0 ]; then
  echo "usage, as root: tests/fresh/run.sh FOLDER" >&2
  exit 2
fi
tree=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
root=$folder/root
tar=$folder/bookworm.tar

say() { printf '\n=== %s\n' "$*"; }
fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb "$@"; }
as_user() { in_root su user -s /bin/sh -c "cd /home/user/tree && $1"; }

clean_up() {
  for mount in dev/pts dev proc; do
    ! mountpoint -q "$root/$mount" || umount "$root/$mount"
  done
  [ -n "${KEEP-}" ] || rm -rf --one-file-system "$root"
}

if [ ! -e "$tar" ]; then
  say "making a minimal Debian 12"
  rm -rf "$folder/new"
  debootstrap --variant=minbase bookworm "$folder/new" ${MIRROR-}
  tar -C "$folder/new" -cf "$tar.part" .
  mv "$tar.part" "$tar"
  rm -rf "$folder/new"
fi

say "unpacking it"
[ ! -e "$root" ] || fail "$root is there already; remove it"
mkdir -p "$root"
trap clean_up EXIT
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

say "1. command 1 without rights"
status=0
as_user script/setup.sh >"$folder/log1" 2>&1 || status=$?
cat "$folder/log1"
[ "$status" = 3 ] || fail "exit status $status instead of 3"
grep -q 'apt-get install -y --no-install-recommends g++ make' "$folder/log1" || fail "no line for the administrator"

say "2. command 1 as root"
in_root sh -c 'cd /home/user/tree && script/setup.sh'
[ -s "$root/home/user/tree/build/sample.jpg" ] || fail "no picture"
in_root chown -R user:user /home/user/tree

say "3. command 2 as user"
as_user 'make test'

say "4. command 1 again"
in_root sh -c 'cd /home/user/tree && script/setup.sh' >"$folder/log4" 2>&1
cat "$folder/log4"
! grep -q apt-get "$folder/log4" || fail "a second run calls apt"
in_root chown -R user:user /home/user/tree

say "5. make install, and the installed program elsewhere"
as_user 'make install DESTDIR=/home/user/stage PREFIX=/opt'
stage=/home/user/stage/opt
as_user "cd / && $stage/bin/raypro $stage/share/raypro/scenes/hello.scn /home/user/hello.png"
[ -s "$root/home/user/hello.png" ] || fail "the installed program made no picture"
as_user "cd / && $stage/bin/rayimg info /home/user/hello.png"

say "6. make uninstall"
as_user 'make uninstall DESTDIR=/home/user/stage PREFIX=/opt'
left=$(find "$root/home/user/stage" -mindepth 1)
[ -z "$left" ] || fail "left behind: $left"
as_user 'make installcheck'

say "all is well"
