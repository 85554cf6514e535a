#!/bin/bash
# script/farm/slurm.sh through a Slurm of two nodes on loopback: whatever happens to a part, the image is that of one
# machine. Exit status 77: something is not installed here, or does not start.
set -eu
. "$(dirname "$0")/loopback.sh"
needs sbatch squeue slurmctld slurmd munged

host=$(uname -n)
controller=$(free_port $((16000 + $$ % 1300 * 3)))
first=$(free_port $((controller + 1)))
second=$(free_port $((first + 1)))
chmod 755 "$place"
head -c 1024 /dev/urandom > munge.key
chmod 400 munge.key
mkdir state spool-n1 spool-n2
cat > slurm.conf << CONF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
AuthInfo=socket=$place/munge.socket
AuthType=auth/munge
CredType=cred/munge
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$controller
SlurmctldPidFile=$place/slurmctld.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdPidFile=$place/slurmd-%n.pid
SlurmdLogFile=$place/slurmd-%n.log
SlurmdSpoolDir=$place/spool-%n
StateSaveLocation=$place/state
SlurmdTimeout=2
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
JobRequeue=0
SchedulerParameters=sched_interval=1,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=n1 NodeAddr=127.0.0.1 NodeHostname=$host Port=$first CPUs=1
NodeName=n2 NodeAddr=127.0.0.1 NodeHostname=$host Port=$second CPUs=1
PartitionName=lab Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$place/slurm.conf"
munged --force -S "$place/munge.socket" --key-file="$place/munge.key" --pid-file="$place/munge.pid" \
  --log-file="$place/munge.log" --seed-file="$place/munge.seed" > said 2>&1 || skip "munged does not start: $(cat said)"
slurmctld -f "$SLURM_CONF" > said 2>&1 || skip "slurmctld does not start: $(cat said)"
for node in n1 n2; do
  slurmd -N "$node" -f "$SLURM_CONF" > said 2>&1 || skip "slurmd does not start: $(cat said)"
done
for i in $(seq 40); do
  [ "$(sinfo -h -N -o %T 2> /dev/null | sort -u)" != idle ] || break
  [ "$i" -lt 40 ] || skip "Slurm does not start: $(tail -n 1 slurmctld.log)"
  sleep 0.25
done

more=("${@:3}")
farm() { (cd work && "$root/script/farm/slurm.sh" "$@" in.scn out.png "${more[@]}") >> said 2>&1; }
wait_for_jobs() {
  for i in $(seq 280); do
    jobs=$(squeue -h 2> /dev/null) || jobs='a busy controller does not say'
    # What the jobs say is gone with their log once the image is there.
    cp work/out.png.log said-by-jobs 2> /dev/null || true
    [ -n "$jobs" ] || return 0
    sleep 0.1
  done
  squeue >&2
  fail "the jobs do not end"
}

case ${CASE:-all} in
  accidents | all)
    echo "$killed" > accidents/2
    echo "$full_disk" > accidents/3
    echo "$late_clock" > accidents/1
    echo damaged > work/out.png.part-4-of-5
    farm -parts 5 || fail "status $?"
    wait_for_jobs
    expect_image "a killed worker, a full disk, a damaged part, a wrong clock"
    grep -q 'part-4-of-5' said said-by-jobs || fail "nobody named the damaged part" ;;&
  rounds | all)
    render_with "${more[@]}" -error 6 -samples 512
    farm -parts 2 || fail "status $?"
    wait_for_jobs
    expect_image "rounds" ;;&
  time | all)
    render_with "${more[@]}" -time 600
    farm -parts 3 || fail "status $?"
    wait_for_jobs
    expect_image "a time that is long enough" ;;&
  movie | all)
    expect_movie -slurm "--cpus-per-task=1" ;;&
  twice | all)
    farm -parts 4 & first_job=$!
    (cd work && "$root/script/farm/slurm.sh" -watch -parts 4 in.scn out.png "${more[@]}") > said2 2>&1 || fail "the second job"
    wait "$first_job" || fail "the first job"
    wait_for_jobs
    grep -q 'of 4 parts rendered' said2 || fail "-watch says nothing"
    expect_image "two jobs of one name" ;;&
  overtaken | all)
    overtaken > accidents/1
    farm -parts 1 || fail "status $?"
    wait_for_jobs
    expect_image "a job that another one of its name overtook" ;;&
  node | all)
    # The node goes, and with it what it was doing.
    cat > accidents/1 << 'VANISH'
up=$PPID
while [ "$(ps -o comm= "$up")" != slurmstepd ]; do up=$(ps -o ppid= "$up" | tr -d ' '); done
kill -9 "$(cat "$place/slurmd-$SLURMD_NODENAME.pid")" "$up"; exit 1
VANISH
    farm -parts 4 || fail "status $?"
    wait_for_jobs
    expect_image "a node that vanishes" ;;&
  hopeless | all)
    touch always-2
    farm -parts 3 || fail "status $?"
    wait_for_jobs
    [ ! -e work/out.png ] || fail "there is an image though a part never was"
    grep -q 'failed.*: 2$' work/out.png.log || fail "nobody named the hopeless part"
    rm always-2
    farm -parts 3 || fail "status $?"
    wait_for_jobs
    expect_image "a second command" ;;
esac
