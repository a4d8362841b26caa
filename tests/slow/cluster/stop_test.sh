#!/bin/bash
# Jobs of `make cluster` that are stopped or run out of time on a real Slurm continue from checkpoints.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../../pipeline/support.sh"
source "${0%/*}/jobs.sh"

test_stopped_trainings_continue_from_checkpoints() {
  small_grid 2000
  cluster cluster >/dev/null
  wait_for results/t/simulated-small/seed1/piae-dt/train.log
  wait_for results/t/simulated-small/seed0/piae-dt/train.log
  # A second submission is refused while the first is in the queue.
  expect_line "$(cluster cluster)" 'jobs of this run are in the queue already: '
  expect_line "$(cluster status)" '^  cells: 1 running$'
  expect_line "$(cluster status)" '^  tables: 1 pending \(Dependency\)$'
  sleep 1
  expect_line "$(cluster cluster-stop)" '^stopped: job '
  expect_equal "$(squeue --noheader)" ""
  wait_for results/t/simulated-small/seed0/piae-dt/model.h5.checkpoint
  wait_for results/t/simulated-small/seed1/piae-dt/model.h5.checkpoint
  expect_in_log cells.0.log 'life ended .* status 75: stopped by scancel'
  [[ ! -e results/t/simulated-small/tables.md ]] || fail "the tables were made after all"
  expect_line "$(cluster cluster)" '^submitted as job [0-9]+ \(cells\), [0-9]+ \(tables\)$'
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_as_alone all
}

test_a_job_out_of_time_is_requeued_and_continues_from_its_checkpoint() {
  small_grid 2000
  # Each of the two trainings is a job.
  local grid=("${grid[@]}" METHODS=piae-dt RATIOS=10to1)
  printf '%s\n' stage,dataset,method,classifier,ratio,seconds,megabytes train,simulated-small,piae-dt,,,100,200 >jobs/costs.csv
  cluster cluster MINUTES=1 CORES=1 >/dev/null
  local cells last=1
  cells=$(id_of cells)
  wait_for_job RUNNING "${cells}_$last"
  wait_for_line "cells.$last.log" 'life started'
  sleep 3
  # Slurm sends this before the limit.
  scancel --batch --signal=USR1 "${cells}_$last"
  wait_for_line "cells.$last.log" 'status 75: out of time, goes back into the queue'
  wait_for_job PENDING "${cells}_$last"
  begin_again "${cells}_$last"
  wait_for_line tables.log '^job: life ended .* status 0: done'
  expect_equal "$(lives "cells.$last.log")" 2
  expect_equal "$(lives cells.0.log)" 1
  expect_in_log tables.log '^spent: 1 jobs began again'
  expect_as_alone all
}

test_a_life_that_makes_nothing_new_is_not_requeued() {
  small_grid 2
  instead_of_train 'trap "exit 75" TERM USR1; while :; do sleep 0.1; done'
  cluster cluster SEEDS=1 METHODS="none piae-dt" >/dev/null
  local cells
  cells=$(id_of cells)
  # Everything that can be made has been made.
  wait_for results/t/simulated-small/seed1/none/100to1/wdcnn/diagnosis.h5
  wait_for results/t/simulated-small/seed1/none/100to1/wdcnn/features.h5
  scancel --batch --signal=USR1 "${cells}_0"
  wait_for_line cells.0.log 'out of time, goes back'
  begin_again "${cells}_0"
  until_true "the job started again" has_started_twice
  sleep 2
  scancel --batch --signal=USR1 "${cells}_0"
  wait_for_line cells.0.log 'this life made nothing new'
  until_done
  expect_equal "$(lives cells.0.log)" 2
  expect_in_log tables.log '^missing: '
}

test_tables_that_take_too_long_are_stopped_at_once() {
  small_grid 2
  rm bin/tabulate
  printf '#!/bin/bash\ntouch started\nsleep 20\ntouch ended\nexec %s/tabulate "$@"\n' "$programs" >bin/tabulate
  chmod +x bin/tabulate
  cluster cluster METHODS=none SEEDS=0 >/dev/null
  wait_for_line records.log 'status 0: done'
  wait_for started
  scancel --batch --signal=USR1 "$(id_of tables)"
  wait_for_line tables.log 'status 75: out of time, and this life made nothing new'
  [[ ! -e ended ]] || fail "tabulate was waited for"
}

has_started_twice() { (($(lives cells.0.log) == 2)); }

slurm_up
run_tests "$@"
