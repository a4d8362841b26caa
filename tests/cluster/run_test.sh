#!/bin/bash
# `make cluster` on a real Slurm, with the programs themselves: the whole of a small grid.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../pipeline/support.sh"

# Jobs that take more memory than they asked for are killed, as by most clusters; and n4 has a GPU, or so it
# is told.
eval "$(declare -f slurm_conf | sed '1s/slurm_conf/plain_conf/')"
slurm_conf() {
  echo "Name=gpu File=/dev/null" >"$slurm_folder/gres.conf"
  plain_conf | sed '/^NodeName=n4/s/$/ Gres=gpu:1/'
  printf '%s\n' JobAcctGatherType=jobacct_gather/linux JobAcctGatherFrequency=1 \
    JobAcctGatherParams=OverMemoryKill GresTypes=gpu
}

# Programs that a test may put others in front of, settings with which all takes seconds.
small_grid() {
  mkdir -p bin results
  ln -s "$programs"/* bin
  cp -r "$project/results/published" results
  sed -i -E "s/^epochs = [0-9]+/epochs = 2/; /^\[train.piae-dt\]/,/^\[/s/^epochs = .*/epochs = ${1:-2}/" pipeline/protocol.toml
}
grid=(BIN=bin DATASETS=simulated-small METHODS="none smote piae-dt" RATIOS="100to1 10to1" SEEDS="0 1" LIBTORCH=off)
cluster() { # target of make, variables
  make --silent "$1" "${grid[@]}" RUN=t CORES=2 "${@:2}" 2>&1
}
alone() { make --silent -j2 "$1" "${grid[@]}" RUN=alone "${@:2}" >/dev/null 2>&1; }
id_of() { awk -v kind="$1" '$1 == kind { print $2 }' results/t/.jobs/*/submitted | tail -n 1; }
nothing_queued() { [[ -z $(squeue --noheader) ]]; }
until_done() { until_true "all jobs have ended" nothing_queued; }
in_log() { grep -qE -- "$2" results/t/.jobs/*/"$1"; }
# Artefacts and tables, without logs and what says when and where.
bytes_of() {
  (cd "results/$1" && find . -name .jobs -prune -o -type f ! -name '*.log' ! -name 'run.html' ! -name 'report.*' \
    ! -path '*/.settings/*' -exec sha256sum {} + | sort -k 2)
}
expect_as_alone() {
  alone "$@"
  bytes_of t >bytes_of_jobs
  bytes_of alone >bytes_alone
  expect_equal "$(diff bytes_of_jobs bytes_alone)" ""
}

# Without asking Slurm, whose requests are counted.
wait_for_line() { # log of a job, pattern
  local tries=0
  until in_log "$1" "$2" 2>/dev/null; do
    sleep 0.2
    ((++tries < 900)) || fail "no line like '$2' in $1:"$'\n'"$(cat results/t/.jobs/*/*.log)"
  done
}
requests() { sdiag | awk '/^\tREQUEST_/ && match($0, /count:[0-9]+/) { n += substr($0, RSTART + 6, RLENGTH - 6) } END { print n }'; }

test_the_grid_in_jobs_ends_in_the_same_bytes_as_without() {
  small_grid
  local before output
  before=$(requests)
  SECONDS=0
  output=$(OMP_NUM_THREADS=3 cluster cluster)
  expect_line "$output" '^records +1 +2 '
  expect_line "$output" '^submitted as job [0-9]+ \(records\), [0-9]+ \(cells\), [0-9]+ \(tables\)$'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  (($(requests) - before <= SECONDS)) || fail "$(($(requests) - before)) requests in $SECONDS s"
  in_log tables.log '^spent: 26 steps in 3 jobs; ' || fail "$(cat results/t/.jobs/*/tables.log)"
  expect_as_alone all
  expect_line "$(cluster status)" '^all +10 +10 +0 +0 +0 '
  until_done
  expect_line "$(cluster cluster-plan)" '^1 submissions'
}

test_stopped_trainings_leave_checkpoints_and_the_same_command_goes_on() {
  small_grid 300
  cluster cluster >/dev/null
  wait_for results/t/simulated-small/seed1/piae-dt/train.log
  wait_for results/t/simulated-small/seed0/piae-dt/train.log
  # Twice is refused while the first is in the queue.
  expect_line "$(cluster cluster)" 'jobs of this run are in the queue already: '
  expect_line "$(cluster status)" '^  cells: 1 running$'
  expect_line "$(cluster status)" '^  tables: 1 pending \(Dependency\)$'
  sleep 1
  expect_line "$(cluster cluster-stop)" '^stopped: job '
  expect_equal "$(squeue --noheader)" ""
  wait_for results/t/simulated-small/seed0/piae-dt/model.h5.checkpoint
  wait_for results/t/simulated-small/seed1/piae-dt/model.h5.checkpoint
  in_log cells.0.log 'life ended .* status 75: stopped by scancel' || fail "$(cat results/t/.jobs/*/cells*.log)"
  [[ ! -e results/t/simulated-small/tables.md ]] || fail "the tables were made after all"
  expect_line "$(cluster cluster)" '^submitted as job [0-9]+ \(cells\), [0-9]+ \(tables\)$'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_as_alone all
}

# A train that does otherwise than it should for one seed.
instead_of_train() { # what it does
  rm bin/train
  printf '#!/bin/bash\nif [[ $* == *seed1/piae-dt/* && ! -e well ]]; then\n%s\nfi\nexec %s/train "$@"\n' "$1" "$programs" >bin/train
  chmod +x bin/train
}

test_a_failed_cell_is_named_and_the_tables_are_of_the_others() {
  small_grid
  instead_of_train 'echo "train: the reason" >&2; exit 65'
  cluster cluster >/dev/null
  wait_for_line tables.log '^job: life ended .* status 1: some steps failed'
  in_log tables.log '^missing: 3 files that the tables are made of' || fail "$(cat results/t/.jobs/*/tables.log)"
  in_log tables.log '^  results/t/simulated-small/seed1/piae-dt/10to1/diagnosis.h5$' || fail "$(cat results/t/.jobs/*/tables.log)"
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
  small_grid
  # shellcheck disable=SC2016
  instead_of_train 'hog=$(head -c 600000000 /dev/zero | tr "\0" x); sleep 60'
  SBATCH_MEM_PER_NODE=500M cluster cluster >/dev/null
  until_done
  local output
  output=$(cluster status)
  expect_line "$output" '^  simulated-small/seed1/piae-dt: train: its job ended: out of memory \(log: '
  expect_line "$output" '^  cells.0: out of memory \(log: '
  in_log tables.log '^missing: ' || fail "the last job did not say what is missing"
}

# Lives of a job.
lives() { grep -c '^job: life begun' results/t/.jobs/*/"$1"; }

test_out_of_time_a_job_goes_back_and_no_other_does_and_goes_on_from_the_checkpoint() {
  small_grid 300
  # Each of the two trainings is a job.
  local grid=("${grid[@]}" METHODS=piae-dt RATIOS=10to1)
  printf '%s\n' stage,dataset,method,ratio,seconds,megabytes train,simulated-small,piae-dt,,100,200 >jobs/costs.csv
  cluster cluster MINUTES=1 CORES=1 >/dev/null
  local cells last=1
  cells=$(id_of cells)
  wait_for_job RUNNING "${cells}_$last"
  wait_for_line "cells.$last.log" 'life begun'
  sleep 3
  # What Slurm sends before the limit.
  scancel --batch --signal=USR1 "${cells}_$last"
  wait_for_line "cells.$last.log" 'status 75: out of time, goes back into the queue'
  wait_for_job PENDING "${cells}_$last"
  until_true "the job has left its node" scontrol update JobId="${cells}_$last" StartTime=now
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_equal "$(lives "cells.$last.log")" 2
  expect_equal "$(lives cells.0.log)" 1
  in_log tables.log '^spent: 1 jobs began again' || fail "$(cat results/t/.jobs/*/tables.log)"
  expect_as_alone all
}

test_a_life_that_makes_nothing_new_is_the_last() {
  small_grid
  instead_of_train 'trap "exit 75" TERM USR1; while :; do sleep 0.1; done'
  cluster cluster SEEDS=1 METHODS="none piae-dt" >/dev/null
  local cells
  cells=$(id_of cells)
  wait_for results/t/simulated-small/seed1/none/100to1/diagnosis.h5
  scancel --batch --signal=USR1 "${cells}_0"
  wait_for_line cells.0.log 'out of time, goes back'
  until_true "the job has left its node" scontrol update JobId="${cells}_0" StartTime=now
  until_true "the job began again" test 2 = "$(lives cells.0.log)" || true
  until [[ $(lives cells.0.log) == 2 ]]; do sleep 0.2; done
  sleep 2
  scancel --batch --signal=USR1 "${cells}_0"
  wait_for_line cells.0.log 'nothing new was made in this life'
  until_done
  expect_equal "$(lives cells.0.log)" 2
  in_log tables.log '^missing: '
}

test_what_asks_for_cuda_is_submitted_to_the_gpus_partition() {
  small_grid
  printf '\n[train.smote]\nneighbours = 4\ndevice = "cuda"\n' >>pipeline/protocol.toml
  awk '/^\[train.smote\]/ && !once++ { skip = 1; next } /^\[/ { skip = 0 } !skip' pipeline/protocol.toml >protocol
  mv protocol pipeline/protocol.toml
  expect_line "$(cluster cluster GPU_PARTITION=gpu)" '\(cells-gpu\)'
  expect_equal "$(squeue --noheader --array --format='%P %b' --jobs="$(id_of cells-gpu)")" "gpu gres:gpu:1"
  cluster cluster-stop >/dev/null
}

test_logs_that_cannot_be_written_are_noticed_before_anything_is_submitted() {
  small_grid
  mkdir -p results/t
  : >results/t/.jobs
  expect_line "$(cluster cluster)" 'results/t/.jobs cannot be written, .*; nothing is submitted$'
  expect_equal "$(squeue --noheader)" ""
}

test_a_job_that_is_refused_takes_the_others_with_it() {
  small_grid
  expect_line "$(SBATCH_PARTITION=none cluster cluster)" 'sbatch refused the job records, see above; nothing is left in the queue'
  expect_equal "$(squeue --noheader)" ""
}

slurm_up
run_tests
