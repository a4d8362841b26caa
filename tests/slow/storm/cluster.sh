#!/bin/bash
# A storm over a run on a real Slurm: first each kind of event once, then random ones. After each event the run must
# finish, by itself or by the same command, with the bytes of `make -j2` and without losing a checkpoint. Prints a line
# for each event.
# usage: tests/slow/storm/cluster.sh [EVENTS [SEED]]      20 and 0; exit 77 without Slurm
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../cluster/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"
source "${0%/*}/../cluster/tiny_grid.sh"

events=${1:-20}
RANDOM=$((${2:-0} + 1))
# Continuous integration uses the first two: one leaves a checkpoint, the other does not.
kinds=(scancel_a_step kill_to_a_stage term_to_srun term_to_a_stage time_limit slurmd_killed
  slurmctld_restarted requeue)

# Makes one checkpoint for each seed in advance, so that every event has one to lose.
make_checkpoints() {
  cd "$alone" || exit
  local seed
  for seed in 0 1; do
    mv "results/tiny/tiny/seed$seed/piae-dt" "whole$seed"
  done
  "${tiny[@]}" -j2 cells >messages 2>&1 &
  local make=$!
  wait_until_it_trains
  kill -TERM $make
  wait $make
  for seed in 0 1; do
    mv "results/tiny/tiny/seed$seed/piae-dt/model.h5.checkpoint" "checkpoint$seed"
    rm -r "results/tiny/tiny/seed$seed/piae-dt"
    mv "whole$seed" "results/tiny/tiny/seed$seed/piae-dt"
  done
}

lay_out_event() {
  nearly_done
  local seed folder
  for seed in 0 1; do
    folder=results/tiny/tiny/seed$seed/piae-dt
    rm -rf "$folder"
    mkdir "$folder"
    cp "$alone/checkpoint$seed" "$folder/model.h5.checkpoint"
  done
}

# ---- the run: a job for each step, or one job for all ---------------------------------------------------
options=(-k -j2 tables)
start_steps() { # further options of srun
  "${tiny[@]}" "${options[@]}" SUBMIT="$one_job_a_step $1" >messages 2>&1 &
  make=$!
  job=
}
start_batch() {
  { printf '#!/bin/bash\n' && printf '%q ' "${tiny[@]}" "${options[@]}" "SUBMIT=$one_job_a_step --exact"; } >job
  job=$(sbatch --parsable --requeue --nodes=1 --ntasks=2 --mem=2000 --output=messages --open-mode=append job)
}
has_ended() {
  if [[ $job ]]; then
    in_state COMPLETED "$job" || in_state FAILED "$job"
  else
    [[ ! $(jobs -r) ]]
  fi
}
ended_well() {
  if [[ $job ]]; then in_state COMPLETED "$job"; else wait "$make"; fi
}

# ---- the events: each starts the run and disturbs it -----------------------------------------------------
some_time() { sleep "$((RANDOM % 2)).$((RANDOM % 10))"; }
one_of() { shuf --head-count=1 --random-source=<(yes $RANDOM); }
stages=("$programs"/{train,generate,score,diagnose,tabulate})
# Signals one of the present processes; if it has just ended, one of the next.
hit() { # signal, programs
  local process
  until has_ended && too_late=yes; do
    process=$(for program in "${@:2}"; do running "$program"; done | one_of)
    [[ ! $process ]] || ! kill "-$1" "$process" || return 0
  done
}
# srun is two processes; the second one supervises the first.
hit_srun() { # signal
  local process
  until has_ended && too_late=yes; do
    process=$(running "$(command -v srun)" | head -n 1)
    [[ ! $process ]] || ! kill "-$1" "$process" || return 0
  done
}
a_running_job() { # format for squeue; sets `running_job`; fails if none is left
  until has_ended && too_late=yes; do
    running_job=$(squeue --noheader --states=RUNNING --format="$1" | one_of)
    [[ ! $running_job ]] || return 0
  done
  return 1
}

start_and_wait() {
  start_steps "$@"
  wait_until_it_trains
  some_time
}
term_to_srun() {
  start_and_wait ''
  hit_srun TERM
}
term_to_a_stage() {
  start_and_wait ''
  hit TERM "${stages[@]}"
}
kill_to_a_stage() {
  start_and_wait ''
  hit KILL "${stages[@]}"
}
scancel_a_step() {
  start_and_wait ''
  a_running_job %i && scancel "$running_job"
}
# A minute is Slurm's smallest limit; meanwhile the stage is stopped.
time_limit() {
  start_steps --time=1
  wait_until_it_trains
  hit STOP "$programs/train"
}
slurmd_killed() {
  start_and_wait ''
  a_running_job %N || return
  local node=$running_job
  kill_node "$node"
  # A slurmd that returns before it is missed leaves its jobs running forever.
  until_true "$node is down" is_down "$node"
  start_node "$node"
}
slurmctld_restarted() {
  start_steps ''
  wait_until_it_trains
  sleep 3 # a killed slurmctld forgets submissions of the last 3 s
  restart_ctld
}
requeue() {
  start_batch
  wait_until_it_trains
  some_time
  scontrol requeue "$job" || return 0
  until_true "job $job waits" in_state PENDING "$job" || return
  ! lost_checkpoint || lost=yes # before the job's second life overwrites the logs
  begin_again "$job"
}

# ---- the outcome ------------------------------------------------------------------------------------------
# A training that ended with 75 has reported a checkpoint of its own: then the prepared one does not count.
lost_checkpoint() {
  local seed folder
  for seed in 0 1; do
    folder=results/tiny/tiny/seed$seed/piae-dt
    grep -q 'starts again' "$folder/train.log" && return 0
    [[ ! -f $folder/model.h5 ]] || continue
    [[ -f $folder/model.h5.checkpoint ]] || return 0
    grep -q '^step: exit 75 ' "$folder/train.log" &&
      cmp --quiet "$folder/model.h5.checkpoint" "$alone/checkpoint$seed" && return 0
  done
  return 1
}

finish() { # sets `happened`
  local again=0
  until_true "the run ends" has_ended || return
  lost_checkpoint && lost=yes
  if ended_well; then
    happened="ended by itself${too_late:+; the event came too late}"
    return
  fi
  until "${tiny[@]}" "${options[@]}" SUBMIT="$one_job_a_step" >messages 2>&1; do
    ((++again < 3)) || return
  done
  happened="failed; the same command finished it"
}

failures=0
event() { # number, kind; fails if the run ended before it
  local began=$SECONDS happened="DID NOT END" lost='' too_late='' result=same
  lay_out_event
  "$2" 2>>events.log
  finish
  ! lost_checkpoint || lost=yes
  diff -r --exclude='*.log' --exclude=.journal results/tiny "$alone/results/tiny" >difference 2>&1 || result=DIFFERS
  [[ ! $lost ]] || result=lost
  [[ $result == same && $happened != DID* ]] || {
    failures=$((failures + 1))
    head -n 5 difference messages
  } >&2
  printf '%3d  %-20s %-41s %4d s  %s\n' "$1" "${2//_/ }" "$happened" $((SECONDS - began)) "$result"
  until_true "no job is left" no_jobs
  wait_for_nodes
  [[ ! $too_late ]]
}

slurm_up
make_alone
make_checkpoints 2>/dev/null
scratch=$slurm_folder/storm
mkdir "$scratch"
cp -r "$project"/{Makefile,pipeline,jobs} "$scratch"
cd "$scratch" || exit
for ((i = 1; i <= events; ++i)); do
  if ((i <= ${#kinds[@]})); then kind=${kinds[i - 1]}; else kind=${kinds[RANDOM % ${#kinds[@]}]}; fi
  event "$i" "$kind" || event "$i" "$kind"
done
echo "$events events on a Slurm, $failures of them with other bytes, a lost checkpoint or no end"
((failures == 0))
