#!/bin/bash
# Single steps as jobs of a real Slurm (SUBMIT=srun ...): every interruption leaves a checkpoint or fails, and the same
# command then ends with the bytes of `make -j2`.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"
source "${0%/*}/tiny_grid.sh"

start_make() { # make's options; sets `make`, its process id and that of its group
  set -m
  "${tiny[@]}" -j2 tables SUBMIT="$one_job_a_step $1" "${@:2}" >messages 2>&1 &
  make=$!
  set +m
}

expect_failed() {
  local code=0
  wait "$make" || code=$?
  ((code)) || fail "make reports success: $(<messages)"
}

expect_checkpoint() {
  [[ -f $model.checkpoint ]] || fail "there is no checkpoint: $(<"$training") $(<messages)"
  expect_line "$(<"$training") $(<messages)" "^step: exit 75 after"
}

expect_goes_on() {
  until_true "no job is left" no_jobs
  tiny -j2 tables SUBMIT="$one_job_a_step" >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<"$training")" 'going on from'
  expect_same_as_alone
}

stopped_by() { # signal, process or group
  nearly_done
  start_make ''
  wait_until_it_trains
  kill "-$1" -- "${2/make/$make}"
  expect_failed
  expect_checkpoint
  expect_goes_on
}

test_ctrl_c() { stopped_by INT -make; }
test_term_to_make() { stopped_by TERM make; }
test_hang_up() { stopped_by HUP -make; }
test_quit() { stopped_by QUIT -make; }

test_undisturbed() {
  lay_out_grid
  tiny -j8 tables SUBMIT="$one_job_a_step" >messages 2>&1 || fail "$(<messages)"
  expect_same_as_alone
  expect_no_line "$(<messages)" 'srun: warning'
}

test_scancel() {
  nearly_done
  start_make ''
  wait_until_it_trains
  scancel "$(squeue --noheader --format=%i --name=train)"
  expect_failed
  expect_checkpoint
  expect_goes_on
}

# The stage is stopped until Slurm signals it.
test_time_limit() {
  nearly_done
  start_make --time=1
  wait_until_it_trains
  kill -STOP "$(running "$programs/train" | head -n 1)"
  end_time "$(squeue --noheader --format=%i --name=train)"
  expect_failed
  expect_checkpoint
  expect_goes_on
}

# The existing model has another seed. srun returns 0, or 1 on Debian 13.
test_a_lost_node_is_a_failure() {
  nearly_done
  mkdir "${model%/*}"
  cp "$alone/${model/seed0/seed1}" "$model"
  CHECKPOINT_WITHIN=1 start_make ''
  wait_until_it_trains
  # On a loaded machine it would otherwise finish before its node does.
  kill -STOP "$(running "$programs/train" | head -n 1)"
  local node words='(was its node lost|137)'
  (($(slurm_release) < 23)) || words='exit code 1 '
  node=$(squeue --noheader --format=%N --name=train)
  lose_node "$node"
  expect_failed
  expect_line "$(<messages)" "seed0/piae-dt .* failed .*$words"
  start_node "$node"
  wait_for_nodes
  tiny -j2 tables SUBMIT="$one_job_a_step" >messages 2>&1 || fail "$(<messages)"
  expect_same_as_alone
}

test_a_killed_stage() {
  nearly_done
  start_make ''
  wait_until_it_trains
  kill -KILL "$(running "$programs/train" | head -n 1)"
  expect_failed
  expect_line "$(<messages)" 'seed0/piae-dt .* failed with exit code 137 .* killed, perhaps for want of memory'
  tiny -j2 tables SUBMIT="$one_job_a_step" >messages 2>&1 || fail "$(<messages)"
  expect_same_as_alone
}

# Slurm's own USR1 cannot reach a waiting step, so the step is taken out of the queue.
test_a_step_in_the_queue_is_stopped_at_once() {
  nearly_done
  start_make --begin=now+1hour
  until_true "a job waits" in_state PENDING
  kill -TERM "$make"
  expect_failed
  until_true "no job is left" no_jobs
  expect_line "$(tail -n 1 "$training")" '^step: exit 143 after'
  tiny -j2 tables >messages 2>&1 || fail "$(<messages)"
  expect_same_as_alone
}

# On a loaded machine a training would otherwise finish before Slurm signals it. Slurm's SIGCONT, which comes first,
# wakes it.
hold_training() { # seed
  local process held=
  until_true "seed$1 is trained" stage_has_started "${training/seed0/seed$1}"
  for process in $(running "$programs/train"); do
    ! grep -qsz "seed$1/piae-dt/model.h5" "/proc/$process/cmdline" || { kill -STOP "$process" && held=yes; }
  done
  [[ $held ]] || fail "the training of seed$1 is not running: $(<messages)"
}

# Starts a batch job whose steps run in parallel inside its allocation. A script that does not exec make ends at the
# signal, and then Slurm kills its steps.
start_job() { # sets `job`
  nearly_done
  rm -r results/tiny/tiny/seed1/piae-dt
  { printf '#!/bin/bash\nexec ' && printf '%q ' "${tiny[@]}" -j2 tables "SUBMIT=$one_job_a_step --exact"; } >job
  job=$(sbatch --parsable --requeue --nodes=1 --ntasks=2 --mem=2000 --output=messages --open-mode=append job)
  hold_training 0
  hold_training 1
}

expect_requeued() {
  until_true "job $job waits" in_state PENDING "$job"
  expect_checkpoint
}

test_requeue() {
  local job
  start_job
  scontrol requeue "$job"
  expect_requeued
  begin_again "$job"
  until_true "job $job is done" in_state COMPLETED "$job" || fail "$(<messages) $(<"$training")"
  expect_line "$(<"$training")" 'going on from'
  expect_same_as_alone
}

# slurmctld informs srun of the requeue, and srun gives up after KillWait and two more seconds. On a busy node, which
# has not signalled the stages by then, srun returns 0 before they have written checkpoints.
test_requeue_on_a_busy_node() {
  local job slurmd
  start_job
  slurmd=$(slurmd_of "$(squeue --noheader --format=%N --jobs="$job")")
  kill -STOP "$slurmd"
  scontrol requeue "$job"
  until_true "srun has given up" grep -q 'Timed out waiting for job step' "$training"
  kill -CONT "$slurmd"
  expect_requeued
  scancel "$job"
}

slurm_up
make_alone
run_tests "$@"
