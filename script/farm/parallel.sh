#!/bin/sh
# Renders one image on many machines with GNU parallel over ssh, to the bytes that one machine gives. A part that fails
# is tried again, on another machine if there is one; after an interruption the same command continues.
#
#     script/farm/parallel.sh -hosts lab.txt scenes/glass.scn out.png -samples 256
#
#   -hosts file   a machine per line, as in parallel's --sshloginfile: "user@pc7", or ":" for this one (the default)
#   -parts n      parts to cut the image into (default: 4 per machine, so that a slow one holds up few)
#   -copy         the machines do not see this folder by this name: send them the scene's files, and fetch the parts
#   -n            print the commands, and run nothing
# All further words are raypro's. RAYPRO names the program, here and there. See raypro-farm(7).
set -eu
fail() { printf 'parallel.sh: %s\n' "$2" >&2; exit "$1"; }
say() { printf '%s\n' "$*"; }
raypro=${RAYPRO:-raypro} hosts='' parts='' copy='' send='' show='' before='' machines=1
while :; do
  case ${1:-} in -hosts | -parts) [ $# -ge 2 ] || fail 2 "$1 needs a value" ;; esac
  case ${1:-} in
    -copy) copy=raypro-farm-$(uname -n)-$$ ;;
    -n) show=say ;;
    -hosts) hosts=$2; shift ;;
    -parts) parts=$2; shift ;;
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
beside=$(dirname "$(readlink -f "$0" || echo "$0")")/raypro  # as make install puts it
command -v "$raypro" > /dev/null || [ ! -x "$beside" ] || raypro=$beside
command -v parallel > /dev/null || fail 1 "GNU parallel is not installed"
# Lists of words have one a line, and no word of them is a pattern: names may hold blanks and brackets.
IFS='
'
set -f
for file in ${copy:+$("$raypro" "$scene" "$@" -files)}; do
  case $file in /* | *../*) fail 3 "-copy sends what lies below this folder, and the scene reads '$file'" ;; esac
  send=$send$IFS--basefile=$file
done
set +f
# A machine that does not answer is given up after 15 s. Parallel quotes the names that it gives to rsync, which would
# quote them once more since version 3.2.4.
export RSYNC_OLD_ARGS=1 PARALLEL_SSH="${PARALLEL_SSH:-ssh -o BatchMode=yes -o ConnectTimeout=10 -o ServerAliveInterval=5}"
# Beside the scene go the joblog, since it makes the image's folder there, and the plan that a round follows. Words with
# braces would be patterns to parallel: so all are sources of one value, and {2} stands for the first of them.
# shellcheck disable=SC2086  # words
render_parts() {
  set -f
  more=$send words='' here='{2}' n=1
  for file in "$out.joblog" "$out.plan"; do [ ! "$copy" ] || [ ! -f "$file" ] || more=$more$IFS--basefile=$file; done
  [ ! "$copy" ] || more="$more$IFS--cleanup$IFS--return={3}.part-{1}-of-$parts"
  [ ! "$hosts" ] || more=$more$IFS--sshloginfile=$hosts
  [ ! -t 2 ] || more=$more$IFS--eta
  set -- "$PWD" "$out" "$raypro" "$scene" "$out" "$@" -quiet
  for word; do
    n=$((n + 1)); [ $n -le 3 ] || words="$words$IFS{$n}"
    shift; set -- "$@" ::: "$word"
  done
  $show parallel -q --jobs 1 --retries 3 --joblog "$out.joblog" --workdir "${copy:-$here}" $more \
    $words -part "{1}/$parts" :::: - "$@"
  set +f
}
[ ! "$show" ] || render_parts "$@"
# Beside the parts, the image tells whether anything was done: another job of its name makes it and removes them.
until [ "$show" ] || { missing=$("$raypro" "$scene" "$out" "$@" -missing "$parts") || exit; [ ! "$missing" ]; }; do
  now=$missing$({ ls -li "$out"; cksum "$out.part-"*"-of-$parts" "$out.plan"; } 2> /dev/null || true)
  [ "$now" != "$before" ] || fail 1 "these parts failed on every machine: $(echo "$missing" | tr '\n' ' ')"
  before=$now; : > "$out.joblog"
  echo "$missing" | render_parts "$@" || true  # its status is how many parts failed; -missing says which
  cat "$out.joblog" 2> /dev/null | awk -F '\t' -v asked="$(echo "$missing" | wc -l)" '
    $7 $8 == "00" { ++n[$2]; took[$2] += $4; ++parts; all += $4 }
    END { printf "%d of %d parts", parts, asked; for (h in n) printf "; %d on %s at %.1f s%s", n[h], h, took[h] / n[h],
      (took[h] / n[h] * (parts - n[h]) > 2 * (all - took[h]) ? ": slow" : ""); print "" }' >&2
done
$show "$raypro" "$scene" "$out" "$@" -parts "$out.part-*-of-$parts"
$show rm -f "$out.part-"*"-of-$parts" "$out.plan" "$out.joblog"
