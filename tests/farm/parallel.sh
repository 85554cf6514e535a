#!/bin/bash
# script/farm/parallel.sh through GNU parallel and two sshd on loopback: whatever happens to a part, the image is that
# of one machine. Exit status 77: something is not installed here.
set -eu
. "$(dirname "$0")/loopback.sh"
needs parallel ssh sshd ssh-keygen rsync

start_host() {  # name, port
  cat > "sshd-$1.conf" << CONF
Port $2
ListenAddress 127.0.0.1
HostKey $place/host
AuthorizedKeysFile $place/key.pub
PidFile $place/sshd-$1.pid
StrictModes no
UsePAM no
PermitRootLogin yes
CONF
  "$(command -v sshd)" -f "$place/sshd-$1.conf" -E "$place/sshd.log"
}
ssh-keygen -q -t ed25519 -N '' -f key
ssh-keygen -q -t ed25519 -N '' -f host
[ "$user" != root ] || mkdir -p /run/sshd
first=$(free_port $((20000 + $$ % 6000 * 2)))
second=$(free_port $((first + 1)))
start_host a "$first"
start_host b "$second"
printf '%s\n' '# two machines' "$user@127.0.0.1:$first" '' "$user@127.0.0.1:$second" > hosts
export PARALLEL_SSH="ssh -i $place/key -o IdentitiesOnly=yes -o StrictHostKeyChecking=no -o UserKnownHostsFile=$place/known \
-o BatchMode=yes -o LogLevel=ERROR -o ConnectTimeout=5"
export PARALLEL_HOME="$place/parallel"
mkdir parallel; touch parallel/will-cite
for i in 1 2 3 4 5 6 7 8; do
  $PARALLEL_SSH -p "$first" "$user@127.0.0.1" true 2> said && break
  [ "$i" -lt 8 ] || skip "sshd does not let $user in: $(cat said sshd.log 2> /dev/null | tail -n 1)"
  sleep 0.3
done
farm() { (cd work && "$root/script/farm/parallel.sh" "$@" in.scn out.png "${more[@]}") > said 2>&1; }
more=("${@:3}")

case ${CASE:-all} in
  accidents | all)
    echo "$killed" > accidents/2
    echo "$full_disk" > accidents/3
    echo "$late_clock" > accidents/1
    echo damaged > work/out.png.part-4-of-5
    farm -hosts "$place/hosts" -parts 5 || fail "status $?"
    expect_image "a killed worker, a full disk, a damaged part, a wrong clock"
    grep -q 'part-4-of-5' said || fail "nobody named the damaged part" ;;&
  host | all)
    # The machine goes, and with it what it was doing.
    cat > accidents/1 << 'VANISH'
kill -9 "$(cat "$place/sshd-b.pid")"
case $SSH_CONNECTION in *" PORT") ;; *) mv "$place/accidents/done-1" "$place/accidents/2"; exec "$real" "$@" ;; esac
up=$PPID
while [ "$(ps -o comm= "$up")" != sshd ]; do up=$(ps -o ppid= "$up" | tr -d ' '); done
kill -9 "$up"; exit 1
VANISH
    sed -i "s/PORT/$second/" accidents/1
    farm -hosts "$place/hosts" -parts 6 || fail "status $?"
    rm -f accidents/[0-9]*  # the jobs of the other machine may have met it
    expect_image "a machine that vanishes"
    start_host b "$second" ;;&
  copy | all)
    rm -rf ~/raypro-farm-*
    farm -copy -hosts "$place/hosts" -parts 3 || fail "status $?"
    expect_image "machines without a common folder"
    [ -z "$(ls -d ~/raypro-farm-* 2> /dev/null)" ] || fail "files are left on the machines" ;;&
  hopeless | all)
    touch always-2
    ! farm -hosts "$place/hosts" -parts 3 || fail "a part that never was is no failure"
    [ ! -e work/out.png ] || fail "there is an image though a part never was"
    grep -q 'failed on every machine: 2 $' said || fail "nobody named the hopeless part"
    rm always-2
    farm -hosts "$place/hosts" -parts 3 || fail "status $?"
    expect_image "a second command" ;;&
  time | all)
    render_with "${more[@]}" -time 600
    farm -hosts "$place/hosts" -parts 3 || fail "status $?"
    expect_image "a time that is long enough"
    more=("${more[@]}" -time 1 -samples 1000000)
    farm -hosts "$place/hosts" -parts 3 || fail "status $?"
    grep -q 'stopped by time after' said || fail "nobody says that the time was over"
    rm work/out.png ;;&
  movie | all)
    expect_movie -hosts "$place/hosts" ;;&
  overtaken | all)
    overtaken > accidents/1
    farm -hosts "$place/hosts" -parts 1 || fail "status $?"
    expect_image "a job that another one of its name overtook" ;;&
  twice | all)
    farm -hosts "$place/hosts" -parts 4 & first_job=$!
    (cd work && "$root/script/farm/parallel.sh" -parts 4 in.scn out.png "${more[@]}") > said2 2>&1 || fail "the second job"
    wait "$first_job" || fail "the first job"
    expect_image "two jobs of one name" ;;
esac
