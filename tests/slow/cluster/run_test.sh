#!/bin/bash
# `make cluster` on a real Slurm with the real programs: a whole small grid, and possible failures.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"
source "${0%/*}/jobs.sh"

test_the_grid_in_jobs_gives_the_same_bytes_as_make() {
  small_grid 2
  local before output
  before=$(requests)
  SECONDS=0
  output=$(OMP_NUM_THREADS=3 cluster cluster)
  expect_line "$output" '^records +1 +2 '
  expect_line "$output" '^submitted as job [0-9]+ \(records\), [0-9]+ \(cells\), [0-9]+ \(tables\)$'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  (($(requests) - before <= SECONDS)) || fail "$(($(requests) - before)) requests in $SECONDS s"
  expect_in_log tables.log '^spent: 28 steps in 3 jobs; '
  expect_as_alone all
  expect_line "$(cluster status)" '^all +12 +12 +0 +0 +0 '
  until_done
  expect_line "$(cluster cluster-plan)" '^1 submissions'
}

test_a_failed_cell_is_named_and_the_tables_have_the_others() {
  small_grid 2
  instead_of_train 'echo "train: the reason" >&2; exit 65'
  cluster cluster >/dev/null
  wait_for_line tables.log '^job: life ended .* status 1: some steps failed'
  expect_in_log tables.log '^missing: 3 files that the tables need'
  expect_in_log tables.log '^  results/t/simulated-small/seed1/piae-dt/10to1/wdcnn/diagnosis.h5$'
  expect_line "$(<results/t/simulated-small/tables.md)" 'piae-dt'
  [[ -s results/t/report.html ]] || fail "there is no report"
  local output
  output=$(cluster status)
  expect_line "$output" '^  simulated-small/seed1/piae-dt: train: the reason \(log: '
  expect_line "$output" '^  cells.0: some steps failed \(log: '
  until_done
  touch well
  expect_line "$(cluster cluster)" '^submitted as job [0-9]+ \(cells\), [0-9]+ \(tables\)$'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_as_alone all
}

test_lack_of_memory_is_reported_with_the_step() {
  small_grid 2
  # shellcheck disable=SC2016
  instead_of_train 'hog=$(head -c 600000000 /dev/zero | tr "\0" x); sleep 60'
  SBATCH_MEM_PER_NODE=500M cluster cluster >/dev/null
  until_done
  local output
  output=$(cluster status)
  expect_line "$output" '^  simulated-small/seed1/piae-dt: train: its job ended: out of memory \(log: '
  expect_line "$output" '^  cells.0: out of memory \(log: '
  expect_in_log tables.log '^missing: '
}

test_steps_on_cuda_go_to_the_gpu_partition() {
  small_grid 2
  printf '\n[train.smote]\nneighbours = 4\ndevice = "cuda"\n' >>pipeline/protocol.toml
  awk '/^\[train.smote\]/ && !once++ { skip = 1; next } /^\[/ { skip = 0 } !skip' pipeline/protocol.toml >protocol
  mv protocol pipeline/protocol.toml
  expect_line "$(cluster cluster GPU_PARTITION=gpu)" '\(cells-gpu\)'
  expect_line "$(squeue --noheader --array --format='%P %b' --jobs="$(id_of cells-gpu)")" '^gpu gres[:/]gpu:1$'
  cluster cluster-stop >/dev/null
}

test_unwritable_logs_are_reported_before_submitting() {
  small_grid 2
  mkdir -p results/t
  : >results/t/.jobs
  expect_line "$(cluster cluster)" 'results/t/.jobs cannot be written, .*; nothing is submitted$'
  expect_equal "$(squeue --noheader)" ""
}

test_nothing_is_written_through_planted_links() {
  small_grid 2
  mkdir -p results/t/.jobs elsewhere
  echo precious >victim
  ln -s "$PWD/victim" results/t/.jobs/lock
  expect_line "$(cluster cluster)" 'results/t/.jobs or its lock is a link or not a regular file; remove it; nothing is submitted$'
  expect_equal "$(<victim)" precious
  rm results/t/.jobs/lock
  mkfifo results/t/.jobs/lock
  expect_line "$(timeout 20 make --silent cluster "${grid[@]}" RUN=t CORES=2 2>&1)" 'is a link or not a regular file; '
  rm -r results/t/.jobs
  ln -s "$PWD/elsewhere" results/t/.jobs
  expect_line "$(cluster cluster)" 'is a link or not a regular file; '
  expect_equal "$(ls elsewhere)" ""
}

# Covers the folder under another name, squeue's own variables, and a call from a job of an array.
test_a_run_is_submitted_once_under_any_name() {
  small_grid 2
  ln -s "$PWD" link
  cd link
  SLURM_ARRAY_JOB_ID=9 SLURM_ARRAY_TASK_ID=3 cluster cluster METHODS=none >/dev/null
  cd "$(pwd -P)"
  expect_line "$(SQUEUE_STATES=FAILED cluster cluster METHODS=none)" "jobs of this run are in the queue already: .* of $(id -un);"
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_equal "$(lives tables.log)" 1
  until_done
}

test_without_an_answer_of_slurm_nothing_is_stopped() {
  small_grid 2
  mkdir -p results/t
  expect_line "$(SLURM_CONF=/nowhere cluster cluster-stop)" 'Slurm does not answer, see above; nothing is stopped'
  expect_line "$(SBATCH_TIMELIMIT=soon cluster cluster)" "SBATCH_TIMELIMIT: must be minutes, .* not 'soon'"
  [[ ! -e results/t/.jobs ]] || fail "left behind: $(find results/t/.jobs)"
  expect_equal "$(squeue --noheader)" ""
}

test_an_end_that_slurm_does_not_confirm_is_not_reported() {
  small_grid 2
  cluster cluster METHODS=none >/dev/null
  mkdir silent
  # squeue answers once, before the jobs are cancelled.
  printf '#!/bin/bash\n[[ ! -e silent/asked ]] || exit 1\ntouch silent/asked\nexec %q "$@"\n' "$(command -v squeue)" >silent/squeue
  ln -s "$(command -v true)" silent/sleep
  chmod +x silent/squeue
  expect_line "$(PATH=$PWD/silent:$PATH cluster cluster-stop)" 'Slurm does not answer, see above; job [0-9 ]+ may still be ending'
  until_done
}

test_a_new_split_is_planned_with_its_dependents() {
  small_grid 2
  alone all
  mv results/alone results/t
  sed -i 's/^windows-per-class = .*/windows-per-class = 350/' pipeline/protocol.toml
  expect_line "$(cluster cluster-plan)" '^cells +1 +2 .* 23 '
}

test_a_refused_job_cancels_the_others() {
  small_grid 2
  expect_line "$(SBATCH_PARTITION=none cluster cluster)" 'sbatch refused the job records, see above; nothing is left in the queue'
  expect_equal "$(squeue --noheader)" ""
}

test_a_contrast_submits_both_protocols() {
  small_grid 2
  expect_line "$(cluster cluster contrast METHODS=none SEEDS=0 RATIOS=100to1)" '^submitted as job .*records.*cells.*tables'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_line "$(<results/t/simulated-small/protocols.md)" none
  [[ -e results/t-blocked/simulated-small/seed0/none/100to1/wdcnn/diagnosis.h5 ]] || fail "the other protocol was not computed"
  # The submission is known without repeating its variables.
  expect_line "$(make --silent status BIN=bin RUN=t)" '^all +2 +2 +0 +0 +0 '
  until_done
}

test_windows_that_failed_are_tried_once() {
  small_grid 2
  # shellcheck disable=SC2016
  printf '#!/bin/bash\necho called >>simulated; echo "simulate: the reason" >&2; exit 65\n' >bin/simulate.new
  rm bin/simulate
  chmod +x bin/simulate.new
  mv bin/simulate.new bin/simulate
  cluster cluster >/dev/null
  wait_for_line tables.log '^job: life ended .* status 1: some steps failed'
  expect_equal "$(<simulated)" called
  expect_in_log cells.0.log "left out: the job 'records' could not make"
  expect_line "$(cluster status)" 'simulate: the reason'
  until_done
}

slurm_up
run_tests "$@"
