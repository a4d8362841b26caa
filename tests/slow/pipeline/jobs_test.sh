#!/bin/bash
# `make cluster-plan`, and `make cluster` up to Slurm, which a stand-in replaces here. tests/plan tests the division of
# steps among jobs in process; tests/slow/cluster/ runs jobs on a real Slurm.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

plan() { make --silent cluster-plan BIN=fake RUN=t "$@"; }
# Prints the words of a line of the plan, separated by single spaces.
line_of() { awk -v name="$2" '$1 == name { $1 = $1; print }' <<<"$1"; }

# Makes a Slurm that numbers jobs and does not run them.
slurm() {
  mkdir path
  # shellcheck disable=SC2016
  printf '%s\n' '#!/bin/bash' 'echo "$*" >>submissions' 'wc -l <submissions' >path/sbatch
  printf '#!/bin/bash\n' | tee path/squeue >path/scancel
  chmod +x path/*
  PATH=$PWD/path:$PATH
}

test_the_papers_grid_takes_few_submissions() {
  local output
  output=$(plan DATASETS="cwru hit-sm" METHODS=paper)
  expect_equal "$(line_of "$output" records | cut -d' ' -f 1-3)" "records 1 4"
  expect_line "$output" '^cells +[1-9] +4 +0:[0-9]+ h +0\.[0-9] GB +1[67][0-9]+ '
  expect_line "$output" '^3 submissions, which request at most [0-9.]+ core-hours'
}

test_other_goals_are_planned_without_writing() {
  expect_line "$(make --silent cluster-plan sweep BIN=fake RUN=t SEEDS=0)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan readings BIN=fake SEEDS=100)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan identify BIN=fake RUN=t)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan contrast BIN=fake RUN=t SEEDS=0)" '^cells +[2-9] '
  [[ ! -e calls && $(ls results) == published ]] || fail "there is $(find results)"
}

test_only_missing_steps_are_planned() {
  make --silent all BIN=fake RUN=t METHODS=smote RATIOS=10to1 SEEDS=0 >/dev/null 2>&1
  expect_equal "$(line_of "$(plan METHODS=smote RATIOS=10to1 SEEDS=0)" all | cut -d' ' -f 2)" 1
  # Train, generate, score and diagnose, after the split.
  expect_equal "$(line_of "$(plan METHODS=smote RATIOS=10to1 SEEDS="0 1")" cells | cut -d' ' -f 8)" 4
}

# Runs the jobs of the submission in turn, with only the environment that Slurm sets.
run_jobs() { # job:index...
  local task log
  folder=$(echo results/t/.jobs/2*)
  for task; do
    log=$folder/${task/:/.}
    env --ignore-environment PATH="$PATH" SLURM_ARRAY_TASK_ID="${task#*:}" SLURM_CPUS_PER_TASK=2 \
      jobs/job.sbatch "$folder" "${task%:*}" >"${log%.}.log" 2>&1 || fail "$(<"${log%.}.log")"
  done
}

test_submitted_jobs_make_what_make_does() {
  describe
  slurm
  local which=(DATASETS=real METHODS="none smote") folder
  grid "${which[@]}" >/dev/null
  mv results/t one
  echo train,real,smote,,,100,100 >>jobs/costs.csv
  grid cluster "${which[@]}" CORES=2 MINUTES=1 JOBS=3 >output
  expect_line "$(<output)" '^submitted as job 1 \(records\), 2 \(cells\), 3 \(tables\)$'
  expect_line "$(sed -n 2p submissions)" "--array=0-1%3 .*--dependency=afterany:1 jobs/job.sbatch results/t/.jobs/"
  expect_line "$(sed -n 3p submissions)" "--dependency=afterany:1:2 jobs/job.sbatch .* tables$"
  run_jobs records: cells:0 cells:1 tables:
  expect_line "$(<"$folder/tables.log")" "^spent: [0-9]+ steps in 4 jobs; "
  rm -r results/t/.jobs calls
  expect_equal "$(diff -rq --exclude='*.log' --exclude=.journal one results/t)" ""
  # The same records are made again, so everything downstream stays current.
  rm results/t/real/records.h5
  grid cluster "${which[@]}" >/dev/null
  run_jobs records: cells:0 tables:
  expect_equal "$(ran)" "1 ingest"
}

test_a_job_that_cannot_write_its_list_fails() {
  describe
  slurm
  grid cluster DATASETS=real METHODS=none >/dev/null
  local folder status=0
  folder=$(echo results/t/.jobs/2*)
  ln -s /dev/full "$folder/records.to_do"
  env --ignore-environment PATH="$PATH" SLURM_CPUS_PER_TASK=2 jobs/job.sbatch "$folder" records >job.log 2>&1 ||
    status=$?
  expect_equal "$status" 1
  expect_line "$(tail -n 1 job.log)" '^job: life ended at [0-9]+, used [0-9.]+ s, status 1: '
}

test_submit_without_arguments_prints_its_usage() {
  expect_line "$(jobs/submit.sh --help)" '^usage: jobs/submit.sh \[--plan\] CORES=N MINUTES=N '
  expect_exit 0 jobs/submit.sh --help
  expect_line "$(jobs/submit.sh 2>&1 || true)" '^usage: jobs/submit.sh '
  expect_exit 2 jobs/submit.sh
  expect_exit 2 jobs/submit.sh --plan
}

test_without_slurm_make_cluster_fails_in_one_line() {
  mkdir path
  local program
  for program in make bash awk sed basename; do ln -s "$(command -v "$program")" path; done
  expect_exit 2 env PATH="$PWD/path" make cluster
  expect_line "$(PATH=$PWD/path make cluster 2>&1 || true)" 'sbatch is not installed, so there is no Slurm'
  [[ ! -e build ]] || fail "something was built"
}

test_wrong_numbers_and_goals_are_refused() {
  expect_line "$(plan CORES=0 2>&1 || true)" "CORES: must be a whole number from 1 up, not '0'"
  expect_exit 2 make cluster-plan sweep contrast BIN=fake
  expect_line "$(plan transfer 2>&1 || true)" "give one goal of cells, .*, all, not 'transfer'"
  slurm
  expect_exit 2 make cluster BIN=fake RUN=t METHODS=magic
  expect_equal "$(find results/t/.jobs -mindepth 1 ! -name lock)" ""
}

# Goals next to these words only select the question.
test_goals_after_status_and_cluster_stop_are_not_computed() {
  slurm
  local front goal
  for goal in all cells sweep contrast identify readings transfer; do
    for front in status cluster-stop help; do
      make --silent $front $goal BIN=fake SEEDS=100 RATIOS="10to1" >output 2>&1 || fail "$front $goal: $(<output)"
      [[ ! -e calls && $(ls results) == published ]] || fail "make $front $goal has computed: $(<calls)"
    done
  done
  expect_equal "$(make cluster-stop readings BIN=fake)" "no job of results/readings is in the queue"
  expect_equal "$(make --silent cluster-stop sweep BIN=fake RUN=t)" "no job of results/t is in the queue"
}

run_tests "$@"
