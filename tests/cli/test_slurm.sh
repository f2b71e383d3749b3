#!/usr/bin/env bash
# share/slurm: a sweep in four parts on two nodes, of which one part is killed, gives the journal of the whole run. Slurm runs here
# for the time of the test: its daemons, with two nodes that are both this machine.
for daemon in sbatch slurmctld slurmd munged; do
  PATH=$PATH:/usr/sbin command -v $daemon >/dev/null || { echo "skipped: $daemon is not installed"; exit 0; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: Slurm's daemons want root"; exit 0; }
export PATH=$PATH:/usr/sbin
source "$(dirname "$0")/engines.sh"

daemons=()
stop_slurm() {
  squeue -h -o %i 2>/dev/null | xargs -r scancel 2>/dev/null
  for _ in $(seq 100); do
    [ -n "$(squeue -h 2>/dev/null)" ] || break
    sleep 0.1
  done
  for ((i = ${#daemons[@]} - 1; i >= 0; i--)); do kill "${daemons[i]}" 2>/dev/null; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2>/dev/null; done
}
trap 'stop_slurm; rm -rf "$folder"' EXIT
start() { # LOG COMMAND...: a daemon in the foreground, as a child of this script
  local log=$1
  shift
  "$@" >"$log" 2>&1 </dev/null &
  daemons+=($!)
}

port=$((20000 + RANDOM % 10000))
mkdir -p slurm/state
head -c 1024 /dev/urandom >slurm/key
chmod 600 slurm/key
cat >slurm/slurm.conf <<CONF
ClusterName=aobudget
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/slurm/munge
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
MailProg=/bin/true
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
StateSaveLocation=$folder/slurm/state
SlurmdSpoolDir=$folder/slurm/%n
SlurmctldPidFile=$folder/slurm/slurmctld.pid
SlurmdPidFile=$folder/slurm/%n.pid
NodeName=n1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=$(nproc)
NodeName=n2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=$(nproc)
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm/slurm.conf
chmod 755 "$folder" slurm
start slurm/munged.log munged --foreground --force --socket="$folder/slurm/munge" --key-file="$folder/slurm/key" \
  --pid-file="$folder/slurm/munged.pid" --log-file="$folder/slurm/munge.log" --seed-file="$folder/slurm/seed"
for _ in $(seq 100); do [ -S slurm/munge ] && break; sleep 0.1; done
start slurm/slurmctld.log slurmctld -D -c
for node in n1 n2; do start "slurm/$node.log" slurmd -D -N $node; done
for _ in $(seq 300); do [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | sort -u | wc -l)" -eq 2 ] && break; sleep 0.1; done
check "two nodes are idle" test "$(sinfo -h -N -t idle -o %N | sort -u | wc -l)" -eq 2 || tail -n 5 slurm/*.log

wait_jobs() { # until none is left
  for _ in $(seq 600); do
    [ -n "$(squeue -h)" ] || return
    sleep 0.5
  done
  squeue
}

if [ "$failures" -eq 0 ]; then
  measure_whole
  check "three jobs" bash "$share/slurm/aobudget-sweep.sbatch" sweep.yaml
  killed=$(kill_part)
  wait_jobs
  check "a part was killed" test -n "$killed"
  check "each other part is whole" test "$(cat $(ls -d "$OUT"-*-of-4/journal.jsonl | grep -v -- "-$killed-of-4/") | wc -l)" -eq $((200 - sizes[killed]))
  cp "$OUT-$killed-of-4/journal.jsonl" kept
  check "both nodes had a part" test "$(scontrol show job 2>/dev/null | sed -n 's/^ *BatchHost=//p' | sort -u | wc -l)" -eq 2
  check "the merge says how much is missing" grep -qE "[0-9]+ of 200 cases of the plan are in none of the folders" merged-merge-*.log
  check "that is what is there" test "$(wc -l <"$OUT/journal.jsonl")" -eq $((200 - sizes[killed] + $(wc -l <kept)))
  again=$(sbatch --parsable --array="$killed" --exclusive --output=again.log "$share/slurm/aobudget-sweep.sbatch" sweep.yaml part)
  check "the part is started again by itself" test -n "$again"
  sbatch --output=merge.log --dependency="afterok:$again" "$share/slurm/aobudget-sweep.sbatch" sweep.yaml merge >/dev/null
  wait_jobs
  check "it went on" cmp kept <(head -c "$(wc -c <kept)" "$OUT-$killed-of-4/journal.jsonl")
  check "the merge is told" grep -q "merged: 200 cases of 4 folders" merge.log
  check_merged
  [ "$failures" -eq 0 ] || tail -n 5 ./*.log slurm/*.log
fi
finish
