# shellcheck shell=bash
# A real Slurm for tests: slurmctld and four slurmd on this host. They run in a network namespace of their own, because
# without munge their ports are open to everybody who reaches them. To be sourced; the sourcing script is restarted in
# the namespace. Starts within a second, also as an ordinary user.
#
#   slurm_up, slurm_down           start it in $slurm_folder, a new one; end all of it; the script's exit does so,
#                                  too
#   wait_for_job STATE [JOB]       until a job, or any, is in that state (RUNNING, PENDING, COMPLETED, ...)
#   wait_for_nodes                 until all nodes are idle
#   kill_node NODE, start_node NODE    kill its slurmd, stepd and programs by SIGKILL, as in a power failure; start a
#                                 new slurmd
#   lose_node NODE                 kill_node, and inform slurmctld at once
#   end_time JOB                   let the time limit of a running job expire, within 30 s
#   restart_ctld                   kill -9, and a new one that continues from the saved state
#   begin_again JOB                start a requeued job without the two minutes that it would wait
#   slurmd_of NODE                 process id of its slurmd
#   running PROGRAM, no_jobs       process ids of a program's file; true if the queue is empty
#   until_true WHAT COMMAND...     waits up to two minutes; on failure reports what it waited for
#
# Facts about this Slurm:
# - Everything that runs in the namespace belongs to the test, so it is ended by process id. A stepd is not a child of
#   its slurmd and survives it.
# - A node refuses a job that restarts in the second of its revocation.
# - A slurmctld that is killed within 3 s of a submission has lost the job: wait before restart_ctld.
# - `scancel --signal=TERM` goes to the steps; with --batch to the batch script, and with --full to both.
# - A lost node is DOWN after SlurmdTimeout. When its slurmd returns later, ReturnToService makes it idle. If it returns
#   earlier, its jobs run forever (is_down NODE tells).
# - Time limits are in minutes, but EndTime is not. slurmctld checks both every 30 s.
# - A step in an allocation waits for other steps unless --exact is given, and for memory unless --mem= is given.

slurm_nodes=(n1 n2 n3 n4)
slurm_programs=(slurmctld slurmd srun sbatch scontrol scancel squeue)

# Prints the reason in the form that count.awk reads.
cannot_run_slurm() {
  printf '%s: Skipped\n%s\n' "${0##*/}" "$1"
  exit 77
}

# 22 on Debian 12, 24 on Debian 13, with other messages.
slurm_release() {
  local version
  version=$(slurmd -V)
  version=${version#* }
  echo "${version%%.*}"
}

if [[ -z ${IN_SLURM_NAMESPACE:-} ]]; then
  PATH=$PATH:/usr/sbin:/sbin
  for program in "${slurm_programs[@]}"; do
    command -v "$program" >/dev/null ||
      cannot_run_slurm "$program is not installed; \`make test-all\` installs it"
  done
  (($(slurm_release) >= 23)) || [[ $(ls -A /sys/fs/cgroup 2>/dev/null) ]] ||
    cannot_run_slurm "Slurm 22 wants control groups, and nothing is mounted at /sys/fs/cgroup"
  namespace=(unshare --net --uts)
  ((EUID == 0)) || namespace+=(--user --map-current-user --keep-caps)
  "${namespace[@]}" true 2>/dev/null ||
    cannot_run_slurm "a network namespace cannot be made here (${namespace[*]})"
  IN_SLURM_NAMESPACE=1 exec "${namespace[@]}" "$0" "$@"
fi
# This host's name may resolve to an address outside the namespace. With loopback addresses only, Slurm does not resolve
# any name, so add another address that leads nowhere.
hostname localhost
ip link set lo up
ip address add 192.0.2.1/32 dev lo

# The user's environment would give options to srun and sbatch, or look like an allocation.
for variable in "${!SLURM_@}" "${!SBATCH_@}" "${!SRUN_@}"; do unset "$variable"; done

slurm_conf() {
  local folder=$slurm_folder node port=17010
  cat <<CONF
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort=17001
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
DefMemPerCPU=500
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=0,bf_interval=1,sched_interval=1,sched_min_interval=0
JobCompType=jobcomp/filetxt
JobCompLoc=$folder/jobs
AccountingStorageType=accounting_storage/none
ReturnToService=2
SlurmctldTimeout=10
SlurmdTimeout=10
KillWait=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd-%n.log
CONF
  for node in "${slurm_nodes[@]}"; do
    echo "NodeName=$node NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((++port)) CPUs=2 RealMemory=4000"
  done
  echo "PartitionName=all Nodes=n[1-4] Default=YES MaxTime=INFINITE State=UP"
  echo "PartitionName=gpu Nodes=n4 MaxTime=INFINITE State=UP"
}

# slurmd requires control groups even if no plugin uses them, and exits without them, as in a bare container. Versions
# before 23.02 do not know the word.
cgroup_conf() {
  (($(slurm_release) < 23)) || echo CgroupPlugin=disabled
}

# Runs in a subshell, so that the test's shell does not have it as a job.
start_ctld() { (slurmctld -D -f "$SLURM_CONF" >>"$slurm_folder/output" 2>&1 &) }
start_node() { (slurmd -D -N "$1" -f "$SLURM_CONF" >>"$slurm_folder/output" 2>&1 &) }

slurm_up() {
  slurm_folder=$(mktemp -d)
  export SLURM_CONF=$slurm_folder/slurm.conf
  mkdir "$slurm_folder/state" "${slurm_nodes[@]/#/$slurm_folder/spool-}"
  slurm_conf >"$SLURM_CONF"
  cgroup_conf >"$slurm_folder/cgroup.conf"
  trap slurm_down EXIT
  local node
  start_ctld
  for node in "${slurm_nodes[@]}"; do start_node "$node"; done
  # Ends everything even if this script is killed.
  (end_after_us &) >/dev/null 2>&1
  wait_for_nodes || {
    tail -n 3 "$slurm_folder"/slurmd-*.log >&2
    exit 1
  }
}

end_after_us() {
  trap '' HUP INT TERM
  while [[ -e /proc/$$ ]]; do sleep 1; done
  slurm_down
}

# Prints the process ids of everything in the namespace except this script's own.
in_namespace() {
  local here
  here=$(stat --dereference --format=%i /proc/self/ns/net)
  stat --dereference --format='%i %n' /proc/[0-9]*/ns/net 2>/dev/null |
    awk -F '[ /]' -v here="$here" -v script=$$ '$1 == here && $4 != script { print $4 }'
}

slurm_down() {
  local processes process left
  for _ in {1..50}; do
    processes=$(in_namespace)
    left=
    for process in $processes; do
      ((process == BASHPID)) || ! kill -KILL "$process" 2>/dev/null || left=yes
    done
    [[ $left ]] || break
    sleep 0.02
  done
  rm -rf "$slurm_folder"
}

# A node's slurmd and stepd have its log open; programs started by them have its name in their environment.
on_node() { # node
  local process
  for process in $(in_namespace); do
    if readlink "/proc/$process"/fd/* 2>/dev/null | grep -qxF "$slurm_folder/slurmd-$1.log" ||
      tr '\0' '\n' 2>/dev/null <"/proc/$process/environ" | grep -qx "SLURMD_NODENAME=$1"; then
      echo "$process"
    fi
  done
}

# Prints the process ids of a program in the namespace, the oldest first.
running() { # its file
  local process
  for process in $(in_namespace | sort -n); do
    [[ ! "/proc/$process/exe" -ef $1 ]] || echo "$process"
  done
}

slurmd_of() { # node
  local process
  for process in $(running "$(command -v slurmd)"); do
    ! readlink "/proc/$process"/fd/* 2>/dev/null | grep -qxF "$slurm_folder/slurmd-$1.log" || echo "$process"
  done
}

kill_node() {
  local process
  for process in $(on_node "$1"); do kill -KILL "$process" 2>/dev/null; done
  return 0
}

restart_ctld() {
  local process
  for process in $(in_namespace); do
    ! readlink "/proc/$process"/fd/* 2>/dev/null | grep -qxF "$slurm_folder/slurmctld.log" ||
      kill -KILL "$process" 2>/dev/null
  done
  start_ctld
  until_true "slurmctld answers again" scontrol ping
}

# Waits up to two minutes: Slurm's own actions take up to half a minute.
until_true() { # description, command...
  local began=$SECONDS
  until "${@:2}" >/dev/null 2>&1; do
    sleep 0.1
    ((SECONDS - began < 120)) || {
      echo "waited in vain until $1; sinfo, squeue and the logs say:" >&2
      sinfo --Node --long >&2
      squeue >&2
      tail -n 20 "$slurm_folder/slurmctld.log" >&2
      return 1
    }
  done
}

all_idle() { [[ $(sinfo --noheader --partition=all --Format=StateLong | sort -u) == idle* ]]; }
is_down() { sinfo --noheader --nodes="$1" --format=%t | grep -q down; }
wait_for_nodes() { until_true "all nodes are idle" all_idle; }

# Until the job has left its node, Slurm may accept the new time and then replace it by its own.
begin_again() {
  sleep 2
  until_true "job $1 begins again" begins_again "$1"
}
begins_again() {
  [[ $(squeue --noheader --states=all --format=%T --jobs="$1") != @(PENDING|COMPLETING) ]] ||
    { scontrol update JobId="$1" StartTime=now && false; }
}

# Same effect as a SlurmdTimeout of slurmctld.
lose_node() { # node
  kill_node "$1"
  scontrol update NodeName="$1" State=DOWN Reason=lost
}

# Lets the time limit of a running job expire. slurmctld checks the limits twice a minute.
end_time() { scontrol update JobId="$1" EndTime=now+1; }

no_jobs() { [[ ! $(squeue --noheader) ]]; }

# Slurm knows the state of an ended job for five minutes (MinJobAge).
in_state() { squeue --noheader --states=all --format=%T ${2:+--jobs="$2"} | grep -qx "$1"; }
wait_for_job() { until_true "job ${2:-of any number} is $1" in_state "$@"; }
