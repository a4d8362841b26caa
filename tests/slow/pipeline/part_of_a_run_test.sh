#!/bin/bash
# A part of a run is asked for: what the tables then hold, and what is left out of them.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

test_a_part_leaves_the_tables_of_the_whole() {
  finished_grid
  local part
  for part in SEEDS=0 RATIOS="100to1 1to1" METHODS="none smote" "METHODS=piae-dt none" DATASETS=made; do
    grid "$part" >/dev/null
    expect_equal "$(ran)" ""
  done
}

test_a_part_that_adds_something_shares_what_is_there() {
  finished_grid
  grid SEEDS="0 2" DATASETS=real METHODS="none smote" >/dev/null
  expect_equal "$(ran)" "4 diagnose, 1 generate, 1 score, 1 split, 1 tabulate, 1 train"
  expect_line "$(<results/t/real/accuracy.csv)" "--methods none smote --ratios 100to1 10to1 1to1 --seeds 0 2 --classifiers wdcnn --published"
  grid DATASETS=real >/dev/null
  expect_equal "$(ran)" ""
}

# Cells that were made without tables are in the next ones, whatever these are asked for.
test_tables_have_what_was_made_since() {
  finished_grid
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=vae RATIOS=10to1 SEEDS=0 >/dev/null
  rm calls
  grid SEEDS=1 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  rm -r results/t/real/seed0/vae
  grid SEEDS=1 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_what_was_removed_leaves_the_tables() {
  finished_grid
  rm -r results/t/real/seed1
  grid SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
}

left_out() { # data set
  sed -nE 's/.* --leave-out (.*) --published .*/\1/p' "results/t/$1/accuracy.csv"
}

# Nobody has asked for smote: it is not made again, but the tables do not show the old numbers either.
test_what_is_out_of_date_and_not_asked_for_is_left_out_of_the_tables() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  grid METHODS="none piae-dt" >/dev/null
  expect_equal "$(ran)" "2 tabulate"
  expect_equal "$(left_out real)" "seed0/smote seed1/smote"
  grid METHODS="none piae-dt" >/dev/null
  expect_equal "$(ran)" ""
  grid SEEDS=0 >/dev/null
  expect_equal "$(ran)" "4 diagnose, 2 generate, 2 score, 2 tabulate, 2 train"
  expect_equal "$(left_out made)" "seed1/smote"
  grid METHODS=none RATIOS=100to1 SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(ran)" ""
  grid >/dev/null
  expect_equal "$(ran)" "4 diagnose, 2 generate, 2 score, 2 tabulate, 2 train"
  expect_equal "$(left_out made)" ""
}

test_what_is_out_of_date_is_told_by_the_steps_that_would_make_it() {
  finished_grid
  sed -i 's/kernels = 5/kernels = 3/' pipeline/protocol.toml
  grid METHODS="none smote" DATASETS=real >/dev/null
  expect_equal "$(left_out real)" "seed0/piae-dt/score.h5 seed1/piae-dt/score.h5"
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  grid METHODS=none SEEDS=0 DATASETS=real >/dev/null
  expect_line "$(left_out real)" "^seed0/piae-dt/10to1/wdcnn/diagnosis.h5 seed0/piae-dt/1to1/wdcnn/diagnosis.h5 seed0/piae-dt/score.h5 "
  expect_line "$(left_out real)" " seed1/none/100to1/wdcnn/diagnosis.h5 "
  expect_no_line "$(left_out real)" "seed0/none"
  sed -i 's/"#1"/"#2"/' pipeline/datasets/real.toml
  rm calls
  grid METHODS=none SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split, 1 tabulate"
  expect_equal "$(left_out real)" "seed0 seed1"
}

# With or without the words that the run was made with.
test_looking_at_a_run_changes_nothing_of_it() {
  finished_grid
  local before
  before=$(sha256sum results/t/.settings/*.toml)
  make --silent figures report BIN=fake RUN=t >/dev/null
  make --silent report BIN=fake RUN=t METHODS="none smote" SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(sha256sum results/t/.settings/*.toml)" "$before"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

# Whoever only looks at a run makes nothing again, but does not look at old numbers among new ones either.
test_what_is_out_of_date_is_left_out_of_figures_and_report() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  rm -f reports
  make --silent figures report BIN=fake RUN=t >/dev/null
  expect_equal "$(ran)" ""
  expect_line "$(<results/t/real/figures.log)" "--leave-out seed0/smote seed1/smote --published"
  expect_line "$(<reports)" "--leave-out $(echo {made,real}/seed{0,1}/smote)"
  rm -r reports results/t/*/seed*/{none,piae-dt} # a run that is old as a whole is of one kind
  make --silent figures report BIN=fake RUN=t >/dev/null
  expect_no_line "$(<reports) $(<results/t/real/figures.log)" "--leave-out"
}

# A part at a ratio that is not asked for, of a method that is.
test_cells_that_are_not_asked_for_go_with_the_model_that_is_made_again() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  grid DATASETS=real RATIOS=10to1 METHODS=smote SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 score, 1 tabulate, 1 train"
  expect_equal "$(left_out real)" "seed0/smote seed1/smote"
  grid DATASETS=real RATIOS=100to1 METHODS=none SEEDS=0 >/dev/null
  expect_equal "$(ran)" ""
  rm results/t/real/tables.md
  grid DATASETS=real RATIOS=100to1 METHODS=none SEEDS=0 >/dev/null
  expect_equal "$(left_out real)" "seed0/smote/1to1/wdcnn/diagnosis.h5 seed1/smote"
}

test_a_table_that_is_a_goal_is_of_all_that_the_run_holds() {
  finished_grid
  rm results/t/real/tables.md
  make --silent BIN=fake RUN=t DATASETS=real METHODS=none RATIOS=100to1 SEEDS=0 results/t/real/tables.md >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

# As a make at the same time leaves them. An empty --leave-out would swallow the next option.
test_seeds_that_are_only_begun_are_nothing_to_the_tables() {
  finished_grid
  mkdir results/t/real/seed{7,8}
  rm results/t/real/accuracy.csv
  grid DATASETS=real SEEDS=0 >/dev/null
  expect_line "$(<results/t/real/accuracy.csv)" "--seeds 0 --classifiers wdcnn --published"
}

run_tests "$@"
