#!/bin/sh
# Renders one image on many machines with GNU parallel over ssh, to the bytes that one machine gives. A part that fails
# is tried again, on another machine if there is one; after an interruption the same command goes on.
#
#     script/farm/parallel.sh -hosts lab.txt scenes/glass.scn out.png -samples 256
#
#   -hosts file   a machine per line, as in parallel's --sshloginfile: "user@pc7", or ":" for this one (the default)
#   -parts n      parts to cut the image into (default: 4 per machine, so that a slow one holds up few)
#   -copy         the machines share no folder with this one: send them the files of the scene, and fetch the parts
#   -n            print the commands, and run nothing
# All further words are raypro's. RAYPRO names the program, here and there. Without -copy, the machines must see this
# folder by this name. See raypro-farm(7).
set -eu
fail() { printf 'parallel.sh: %s\n' "$2" >&2; exit "$1"; }
need() { [ $# -ge 2 ] || fail 2 "$1 needs a value"; }
raypro=${RAYPRO:-raypro} hosts='' parts='' copy='' send='' show='' before='' round=0 machines=1
while :; do
  case ${1:-} in
    -copy) copy="--cleanup --workdir raypro-farm-$(uname -n)-$$" ;;
    -n) show=echo ;;
    -hosts) need "$@"; hosts=$2; shift ;;
    -parts) need "$@"; parts=$2; shift ;;
    *) break ;;
  esac
  shift
done
[ $# -ge 2 ] || fail 2 "a scene and an image are needed; see the top of $0"
case $1 in -*) fail 2 "there is no option '$1'; options of raypro follow the scene and the image" ;; esac
scene=$1 out=$2; shift 2
case $parts in *[!0-9]* | 0*) fail 2 "-parts must be a whole number above 0, got '$parts'" ;; esac
[ -z "$hosts" ] || machines=$(grep -c '^[[:space:]]*[^#[:space:]]' "$hosts") || fail 3 "'$hosts' names no machine"
parts=${parts:-$((4 * machines))}
command -v parallel > /dev/null || fail 1 "GNU parallel is not installed"

# Beside the scene's files go the joblog, since it makes the image's folder there, and the plan that a round follows.
for file in ${copy:+$("$raypro" "$scene" "$@" -files)}; do
  case $file in /* | *../*) fail 3 "-copy sends what lies below this folder, and the scene reads '$file'" ;; esac
  send="$send --basefile $file"
done
# One part at a time on each machine, whose cores it uses all. A machine that does not answer is given up after 20 s.
export PARALLEL_SSH="${PARALLEL_SSH:-ssh -o BatchMode=yes -o ConnectTimeout=10 -o ServerAliveInterval=5 -o ServerAliveCountMax=4}"
# shellcheck disable=SC2086  # words, of names without spaces
render_parts() {
  plan=$([ ! -f "$out.plan" ] || echo "--basefile $out.plan") eta=$([ ! -t 2 ] || echo --eta)
  $show parallel -q --jobs 1 --retries 3 $eta --joblog "$out.joblog" ${hosts:+--sshloginfile "$hosts"} \
    ${copy:---workdir "$PWD"} ${copy:+$send --basefile "$out.joblog" $plan --return "$out.part-{}-of-$parts"} \
    "$raypro" "$scene" "$out" "$@" -quiet -part "{}/$parts"
}

[ ! "$show" ] || render_parts "$@"
while missing=$("$raypro" "$scene" "$out" "$@" -missing "$parts") || exit; [ "$missing" ] && [ ! "$show" ]; do
  now=$({ echo "$missing"; cat "$out.part-"*"-of-$parts" "$out.plan" 2> /dev/null || true; } | cksum)
  [ "$now" != "$before" ] || fail 1 "these parts failed on every machine: $(echo "$missing" | tr '\n' ' ')"
  before=$now round=$((round + 1))
  echo "round $round: $(echo "$missing" | wc -l) of $parts parts, on $machines machines" >&2
  echo "$missing" | render_parts "$@" || true  # its status is how many parts failed; -missing says which
done
$show "$raypro" "$scene" "$out" "$@" -parts "$out.part-*-of-$parts"
$show rm -f "$out.part-"*"-of-$parts" "$out.plan" "$out.joblog"
