#!/bin/bash
# `make cluster` on a real Slurm with the real programs: a whole small grid, and possible failures.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"
source "${0%/*}/jobs.sh"

test_the_grid_in_jobs_ends_in_the_same_bytes_as_without() {
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

test_a_failed_cell_is_named_and_the_tables_are_of_the_others() {
  small_grid 2
  instead_of_train 'echo "train: the reason" >&2; exit 65'
  cluster cluster >/dev/null
  wait_for_line tables.log '^job: life ended .* status 1: some steps failed'
  expect_in_log tables.log '^missing: 3 files that the tables are made of'
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

test_out_of_memory_is_said_with_the_step() {
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

test_what_asks_for_cuda_is_submitted_to_the_gpus_partition() {
  small_grid 2
  printf '\n[train.smote]\nneighbours = 4\ndevice = "cuda"\n' >>pipeline/protocol.toml
  awk '/^\[train.smote\]/ && !once++ { skip = 1; next } /^\[/ { skip = 0 } !skip' pipeline/protocol.toml >protocol
  mv protocol pipeline/protocol.toml
  expect_line "$(cluster cluster GPU_PARTITION=gpu)" '\(cells-gpu\)'
  expect_line "$(squeue --noheader --array --format='%P %b' --jobs="$(id_of cells-gpu)")" '^gpu gres[:/]gpu:1$'
  cluster cluster-stop >/dev/null
}

test_logs_that_cannot_be_written_are_noticed_before_anything_is_submitted() {
  small_grid 2
  mkdir -p results/t
  : >results/t/.jobs
  expect_line "$(cluster cluster)" 'results/t/.jobs cannot be written, .*; nothing is submitted$'
  expect_equal "$(squeue --noheader)" ""
}

test_nothing_is_written_through_what_was_planted_for_logs() {
  small_grid 2
  mkdir -p results/t/.jobs elsewhere
  echo precious >victim
  ln -s "$PWD/victim" results/t/.jobs/lock
  expect_line "$(cluster cluster)" 'results/t/.jobs or its lock is a link, or no file; remove it; nothing is submitted$'
  expect_equal "$(<victim)" precious
  rm results/t/.jobs/lock
  mkfifo results/t/.jobs/lock
  expect_line "$(timeout 20 make --silent cluster "${grid[@]}" RUN=t CORES=2 2>&1)" 'is a link, or no file; '
  rm -r results/t/.jobs
  ln -s "$PWD/elsewhere" results/t/.jobs
  expect_line "$(cluster cluster)" 'is a link, or no file; '
  expect_equal "$(ls elsewhere)" ""
}

# Covers the folder under another name, squeue's own variables, and a call from a job of an array.
test_a_run_is_submitted_once_however_it_is_called() {
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

test_who_cannot_ask_slurm_stops_nothing_and_says_so() {
  small_grid 2
  mkdir -p results/t
  expect_line "$(SLURM_CONF=/nowhere cluster cluster-stop)" 'Slurm does not answer, see above; nothing is stopped'
  expect_line "$(SBATCH_TIMELIMIT=soon cluster cluster)" "SBATCH_TIMELIMIT: minutes, .* not 'soon'"
  expect_equal "$(squeue --noheader)" ""
}

test_a_new_split_is_planned_with_all_that_comes_of_it() {
  small_grid 2
  alone all
  mv results/alone results/t
  sed -i 's/^windows-per-class = .*/windows-per-class = 350/' pipeline/protocol.toml
  expect_line "$(cluster cluster-plan)" '^cells +1 +2 .* 23 '
}

test_a_job_that_is_refused_takes_the_others_with_it() {
  small_grid 2
  expect_line "$(SBATCH_PARTITION=none cluster cluster)" 'sbatch refused the job records, see above; nothing is left in the queue'
  expect_equal "$(squeue --noheader)" ""
}

test_another_question_takes_a_run_of_both_protocols() {
  small_grid 2
  expect_line "$(cluster cluster contrast METHODS=none SEEDS=0 RATIOS=100to1)" '^submitted as job .*records.*cells.*tables'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_line "$(<results/t/simulated-small/protocols.md)" none
  [[ -e results/t-blocked/simulated-small/seed0/none/100to1/wdcnn/diagnosis.h5 ]] || fail "the other protocol was not computed"
  # The submission is known without repeating its variables.
  expect_line "$(make --silent status BIN=bin RUN=t)" '^all +2 +2 +0 +0 +0 '
  until_done
}

test_windows_that_could_not_be_made_are_asked_for_once() {
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
