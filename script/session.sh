#!/bin/sh
# Makes a movie of a session of rayview, without a display: the viewer follows a script of events, such as -record
# writes, and is drawn again and again while the script's time passes.
#
#     script/session.sh writeup/views/session.events scenes/hello.scn build/session.avi -samples 16
#
#   -fps n             frames per second (default 6)
#   -last file         keep the last frame as well
#   -width n -height n (default 400 300)
#
# All further options are passed to rayview. `tick` and the moves of a drag take frames, and so do `wait rows` and
# `wait trace`, one each, however long they take here; `wait` and a number waits as long. What -image names is thrown away.
# RAYVIEW and RAYIMG name the programs.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$(readlink -f "$0" || echo "$0")")" && pwd)
absolute() { echo "$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"; }
# What lies in a build of the sources, or is installed.
program() {
  for file in "$here/../build/$1" "$here/$1"; do [ ! -x "$file" ] || { echo "$file"; return; }; done
  command -v "$1" || echo "$1"
}
rayview=$(absolute "${RAYVIEW:-$(program rayview)}")
rayimg=${RAYIMG:-$(program rayimg)}
usage() { echo "session.sh: $1; see the top of $0" >&2; exit 2; }

fps=6 last='' width=400 height=300
[ $# -ge 3 ] || usage "a script of events, a scene and an output file are needed"
events=$1 scene=$2 out=$3
shift 3
while [ $# -gt 0 ]; do
  case $1 in -fps | -last | -width | -height) [ $# -ge 2 ] || usage "$1 needs a value" ;; *) break ;; esac
  case $1 in -fps) fps=$2 ;; -last) last=$2 ;; -width) width=$2 ;; -height) height=$2 ;; esac
  shift 2
done
[ -f "$events" ] || { echo "session.sh: no such script: '$events'" >&2; exit 3; }
scene=$(absolute "$scene")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Between `down` and `up` every move is a frame; a `drag` is written as its moves.
awk -v fps="$fps" '
  function frame() { printf "screenshot frame%05d.jpg\n", frames++ }
  function pass(seconds,   i, n) {  # what is left is added to the next
    due += seconds * fps
    n = int(due + 1e-6); due -= n
    for (i = 0; i < n; ++i) { print "tick " 1 / fps; frame() }
  }
  { sub(/#.*/, "") }
  $1 == "tick" { pass($2); next }
  $1 == "drag" {
    held = ""; for (i = 7; i <= NF; ++i) held = held " " $i
    print "down", $2, $3, $4 held
    for (i = 1; i <= 8; ++i) { print "move", $3 + ($5 - $3) * i / 8, $4 + ($6 - $4) * i / 8; pass(1 / fps) }
    print "up", $2, $5, $6 held
    next
  }
  { print }
  $1 == "down" { is_held = 1 }
  $1 == "up" { is_held = 0 }
  ($1 == "move" && is_held) || ($1 == "wait" && ($2 == "rows" || $2 == "trace")) { pass(1 / fps) }
' "$events" > "$work/events"
grep -q '^screenshot' "$work/events" || usage "no time passes in $events: it has no line such as 'tick 1'"

# The viewer tells the names of files that it writes: here they are short.
(cd "$work" && "$rayview" "$scene" -headless -width "$width" -height "$height" -jpeg_quality 60 "$@" \
  -events events -image traced.png > said 2>&1) || { cat "$work/said" >&2; exit 1; }
"$rayimg" movie "$out" -fps "$fps" "$work"/frame*.jpg
if [ "$last" ]; then
  for frame in "$work"/frame*.jpg; do :; done
  cp "$frame" "$last"
fi
