#!/usr/bin/env bash
# A sweep as an array of a real slurmctld and slurmd on this machine, started for the test alone:
#
#   tools/test_sweep_slurm.sh target/release/examples/spin_up
#
# One running task is killed in the middle; the same command again does what is missing. Needs Debian's packages slurm-wlm
# and munge, and to be root.
set -euo pipefail

program=$(realpath "$1") tools=$(dirname "$(realpath "$0")")
folder=$(mktemp -d)
started=()
finish() {
    for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait
    rm -rf "$folder"
}
trap finish EXIT

host=$(hostname -s)
mkdir -p "$folder"/{state,spool,munge}
chmod 755 "$folder"
head -c 1024 /dev/urandom >"$folder/munge.key"
chmod 600 "$folder/munge.key"
munged --foreground --force --socket="$folder/munge/socket" --key-file="$folder/munge.key" --log-file="$folder/munge.log" \
    --pid-file="$folder/munge.pid" --seed-file="$folder/munge.seed" >"$folder/munge.out" 2>&1 &
started+=($!)

cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$host
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf
slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.out" 2>&1 &
started+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >"$folder/slurmd.out" 2>&1 &
started+=($!)
for ((second = 0; second < 30; second++)); do
    sinfo -h -o %T 2>/dev/null | grep -q idle && break
    sleep 1
done
sinfo -h -o %T | grep -q idle || { echo "error: no node came up"; tail -5 "$folder"/slurm*.log; exit 1; }

line=("T_s=5..15 s in 4" "omega_s=1..6 rad/s in 6" elements=8 --outputs=u,v --quiet)
"$program" sweep "${line[@]}" --out "$folder/alone"
"$program" plan "${line[@]}" --out "$folder/shared"
wait_for_all() {
    for ((second = 0; second < 120; second++)); do
        [[ -z $(squeue -h) ]] && return
        sleep 1
    done
    echo "error: the queue does not empty"
    squeue
    exit 1
}

first=$("$tools/sweep_slurm.sh" "$program" "$folder/shared/plan.toml" "$folder/shared" 4)
echo "$first"
array=$(sed 's/^array \([0-9]*\).*/\1/' <<<"$first")
for ((tenth = 0; tenth < 300; tenth++)); do
    [[ -n $(squeue -h -t running -j "${array}_1" 2>/dev/null) ]] && break
    sleep 0.1
done
scancel --signal=KILL --full "${array}_1" || true
scancel "${array}_1" || true
wait_for_all
there() { find "$folder/shared" -name 'point-*.json' | wc -l; }
echo "after the kill: $(there) of 24 points are there"
"$tools/sweep_slurm.sh" "$program" "$folder/shared/plan.toml" "$folder/shared" 4
wait_for_all
[[ $(there) == 24 ]] || { echo "error: $(there) of 24 points"; exit 1; }
cmp "$folder/alone/sweep.csv" "$folder/shared/sweep.csv"
echo "ok: all points are there once, and the table is that of one machine"
