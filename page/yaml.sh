#!/bin/sh
# Fetches what make web needs to read YAML scenes: the sources of yaml-cpp that Debian builds libyaml-cpp-dev of, without
# changing a list of the system. Needs apt-get, dpkg-source and a network; nothing is installed.
#   usage: page/yaml.sh [folder of the build]
set -eu
cd "$(dirname "$0")/.."
mkdir -p "${1:-build}"
build=$(cd "${1:-build}" && pwd)
work=$build/yaml-cpp.new
rm -rf "$work"
mkdir -p "$work/parts" "$work/lists/partial"

# The system's lists, asked for sources.
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ -f "$list" ] && sed -n 's/^deb /deb-src /p' "$list" >> "$work/parts/sources.list"
done
for list in /etc/apt/sources.list.d/*.sources; do
  [ -f "$list" ] && sed 's/^Types:.*/Types: deb-src/' "$list" > "$work/parts/$(basename "$list")"
done

cd "$work"
from_sources() {
  apt-get -q -o APT::Sandbox::User= -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" \
    -o Dir::State::Lists="$work/lists" "$@"
}
from_sources update > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
version=$(dpkg-query -W -f '${source:Version}' libyaml-cpp-dev 2>/dev/null || true)
from_sources source "yaml-cpp${version:+=$version}" >> apt.log 2>&1 || { cat apt.log >&2; exit 1; }
rm -rf "$build/yaml-cpp"
mv "$work"/yaml-cpp-*/ "$build/yaml-cpp"
rm -rf "$work"
echo "$build/yaml-cpp: yaml-cpp ${version:-as Debian has it}; make web reads YAML with it"
