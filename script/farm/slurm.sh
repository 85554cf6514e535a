#!/bin/sh
# Renders one image on a Slurm cluster, to the bytes that one machine gives: an array of jobs, a part each, and behind
# it a job that submits again what is missing, and then assembles the image. out.png.log has what the jobs said. After
# scancel the same command continues; a minute before its time limit a job writes what it has, for the next attempt.
#
#     script/farm/slurm.sh -parts 64 -sbatch "--partition=lab --time=1:00:00" scenes/glass.scn out.png -samples 256
#
#   -parts n       parts to cut the image into (default 16)
#   -sbatch words  options for sbatch, such as a partition, a time limit or cores of each job
#   -watch         stay until the image is there, and tell every few seconds what is done, and what runs where
#   -n             print the commands, and run nothing
# All further words are raypro's. RAYPRO names the program. Nodes must see this folder by this name. See raypro-farm(7).
set -eu
say() { printf '%s\n' "$*"; }
fail() { printf 'slurm.sh: %s\n' "$2" >&2; exit "$1"; }
raypro=${RAYPRO:-raypro} parts=16 sbatch='' show='' watch='' step=submit took=0 before='' self=$0
while :; do
  case ${1:-} in -parts | -sbatch) [ $# -ge 2 ] || fail 2 "$1 needs a value" ;; esac
  case ${1:-} in
    -n) show=say ;;
    -watch) watch=yes ;;
    -parts) parts=$2; shift ;;
    -sbatch) sbatch=$2; shift ;;
    -step) step=$2 before=$3 self=$4; shift 3 ;;  # within a job: of the array, or behind it
    *) break ;;
  esac
  shift
done
[ $# -ge 2 ] || fail 2 "a scene and an image are needed; see the top of $0"
case $1 in -*) fail 2 "there is no option '$1'; options of raypro follow the scene and the image" ;; esac
scene=$1 out=$2; shift 2
case $parts in '' | *[!0-9]* | 0) fail 2 "-parts must be a whole number above 0, got '$parts'" ;; esac
beside=$(dirname "$(readlink -f "$self" || echo "$self")")/raypro  # as make install puts it
command -v "$raypro" > /dev/null || [ ! -x "$beside" ] || raypro=$beside
[ "$step" != part ] || exec "$raypro" "$scene" "$out" "$@" -quiet -part "$SLURM_ARRAY_TASK_ID/$parts"
case $self in /*) ;; *) self=$(cd "$(dirname "$self")" && pwd)/$(basename "$self") ;; esac
[ "$show" ] && missing=1-$parts || missing=$("$raypro" "$scene" "$out" "$@" -missing "$parts")
missing=$(echo "$missing" | paste -s -d , -)
if [ -z "$missing" ]; then
  "$raypro" "$scene" "$out" "$@" -quiet -parts "$out.part-*-of-$parts"
  exec rm -f "$out.part-"*"-of-$parts" "$out.plan" "$out.log"
fi
[ "$show" ] || command -v sbatch > /dev/null || fail 1 "Slurm is not here: there is no sbatch"
# Beside the parts, the image tells whether anything was done: another job of its name makes it and removes them.
now=$({ echo "$missing"; { ls -li "$out"; cat "$out.part-"*"-of-$parts" "$out.plan"; } 2> /dev/null || true; } | cksum | tr ' ' -)
[ "$now" != "$before" ] || fail 1 "these parts failed, and nothing came of trying again: $missing"
# To sbatch, % and a backslash in the name of a log are no letters.
log=$(printf %s "$out.log" | sed '/\\/ { s/\\/&&/g; b
}; s/%/%%/g')
submit() {  # array or dependency, step, and all that follows
  when=$1 next=$2; shift 2
  # shellcheck disable=SC2086  # words of sbatch
  $show sbatch --parsable $sbatch --job-name="$(basename "$out")" --output="$log" --open-mode=append \
    --signal=B:TERM@60 "$when" "$self" -step "$next" "$now" "$self" -parts "$parts" -sbatch "$sbatch" "$scene" "$out" "$@"
}
array=$(submit "--array=$missing" part "$@")
[ ! "$show" ] || { echo "$array"; array='<array>'; }
follow=$(submit "--dependency=afterany:${array%%;*}" follow "$@")
[ ! "$show" ] || { echo "$follow"; exit; }
echo "job $array renders parts $missing; job $follow behind it assembles $out, or submits again what is missing"
while [ "$watch" ] && jobs=$(squeue -h -r -n "$(basename "$out")" -o '%T %N %M') && [ "$jobs" ]; do
  echo "$jobs" | awk -v of="$parts" -v took="$took" '$1 == "RUNNING" { at = at " " $2 " (" $3 ")" } END { left = NR - 1
    printf "%d of %d parts rendered, %d s left; at work:%s\n", of - left, of, took * left / (of - left + 0.1), at }'
  sleep 5; took=$((took + 5))
done
[ ! "$watch" ] || [ ! -e "$out.log" ] || fail 1 "there is no image; $out.log says why"
