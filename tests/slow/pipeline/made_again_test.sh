#!/bin/bash
# What of the grid is made again after a change, and what is not.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

test_second_run_does_nothing() {
  finished_grid
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_dry_run_shows_the_graph_and_makes_nothing() {
  describe
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 62
  expect_equal "$(ran)" ""
  finished_grid
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 0
}

test_to_ask_what_a_changed_setting_would_make_writes_nothing() {
  finished_grid
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  find results -printf '%p %T@ %s\n' >before
  grid -n >/dev/null
  grid -n SEEDS=0 METHODS="none smote" >/dev/null
  expect_exit 1 make --silent -q cells BIN=fake RUN=t DATASETS=real METHODS=smote SEEDS=0
  expect_equal "$(find results -printf '%p %T@ %s\n')" "$(<before)"
  sed -i 's/epochs = 60/epochs = 50/' pipeline/protocol.toml
  expect_exit 0 make --silent -q cells BIN=fake RUN=t DATASETS=real METHODS=smote RATIOS=10to1 SEEDS=0
}

# make itself takes files that one step makes together for as old as they were.
test_a_dry_run_shows_all_that_a_new_split_brings_back() {
  finished_grid
  sed -i 's/^window = 1024/window = 512/' pipeline/protocol.toml
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 60
  describe
  rm results/t/real/seed0/B.h5
  expect_line "$(grid -n)" 'step.sh results/t/real/seed0 split .* --records results/t/real/records.h5 '
  expect_equal "$(ran)" ""
}

test_touching_and_comments_change_nothing() {
  finished_grid
  touch pipeline/*.toml pipeline/datasets/*.toml fake/*
  sed -i 's/# samples/# of 12 kHz/; s/# depth/# how deep/; s/^\[score\]/\n&\n/' pipeline/protocol.toml
  sed -i 's/# a comment/# another/' pipeline/datasets/real.toml
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_an_option_of_one_method_remakes_that_method() {
  finished_grid
  sed -i 's/^  3,/  4,/' pipeline/protocol.toml
  grid >/dev/null
  expect_no_line "$(<calls)" "smote|none"
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
}

test_an_option_remakes_what_is_like_that_method() {
  describe
  printf '[train.ae]\nlike = "piae-dt"\n' >>pipeline/protocol.toml
  grid METHODS="smote ae" >/dev/null
  rm calls
  sed -i 's/^  3,/  4,/' pipeline/protocol.toml
  grid METHODS="smote ae" >/dev/null
  expect_no_line "$(<calls)" "smote"
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
  expect_equal "$(grep -v '^#' results/t/.settings/train.ae.toml)" $'epochs = 200\nlayers = [ 4 ]'
}

test_an_option_of_all_methods_remakes_them() {
  finished_grid
  sed -i 's/epochs = 200/epochs = 100/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "16 diagnose, 8 generate, 8 score, 2 tabulate, 8 train"
}

test_an_option_of_a_late_stage_remakes_that_stage() {
  finished_grid
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "24 diagnose, 2 tabulate"
  sed -i 's/kernels = 5/kernels = 3/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "8 score, 2 tabulate"
}

test_a_description_remakes_its_data_set() {
  finished_grid
  sed -i 's/"#1"/"#2"/' pipeline/datasets/real.toml
  grid >/dev/null
  expect_no_line "$(<calls)" "made"
  expect_equal "$(ran)" "12 diagnose, 4 generate, 1 ingest, 4 score, 2 split, 1 tabulate, 4 train"
}

test_a_description_that_is_like_another_follows_it() {
  finished_grid
  printf 'name = "other"\nlike = "made"\n' >pipeline/datasets/other.toml
  grid DATASETS=other >/dev/null
  expect_line "$(<calls)" '^simulate other'
  rm calls
  sed -i 's/noise = 0.1/noise = 0.2/' pipeline/datasets/made.toml
  grid DATASETS=other >/dev/null
  expect_equal "$(ran)" "12 diagnose, 4 generate, 4 score, 1 simulate, 2 split, 1 tabulate, 4 train"
}

test_a_data_set_may_have_a_split_of_its_own() {
  describe
  printf '[split]\nwindow = 4096\n' >>pipeline/datasets/real.toml
  grid >/dev/null
  expect_line "$(<results/t/real/seed0/A.h5)" '--config results/t/.settings/split.real.toml '
  expect_line "$(<results/t/made/seed0/A.h5)" '--config results/t/.settings/split.toml '
  expect_equal "$(grep -v '^#' results/t/.settings/split.real.toml)" 'window = 4096'
  rm calls
  sed -i 's/= 4096/= 2048/' pipeline/datasets/real.toml
  sed -i 's/= 1024/= 512/' pipeline/protocol.toml
  grid DATASETS=real >/dev/null
  expect_no_line "$(<calls)" "made"
  expect_equal "$(ran)" "12 diagnose, 4 generate, 1 ingest, 4 score, 2 split, 1 tabulate, 4 train"
}

test_stages_read_the_settings_that_were_compared() {
  finished_grid
  expect_equal "$(grep -v '^#' results/t/.settings/train.smote.toml)" $'epochs = 200\nneighbours = 4'
  expect_equal "$(grep -v '^#' results/t/.settings/train.piae-dt.toml)" $'epochs = 200\nlayers = [ 3 ]'
  expect_equal "$(<results/t/.settings/split.toml)" \
    "$(printf '%s\n' '# Made from pipeline/protocol.toml; edit that file, not this one.' \
      '# Options given by make: --protocol random' 'window = 1024')"
}

test_a_lost_window_file_brings_back_its_split() {
  finished_grid
  rm results/t/real/seed0/D.h5
  grid >/dev/null
  expect_equal "$(ran)" "6 diagnose, 2 generate, 2 score, 1 split, 1 tabulate, 2 train"
}

test_a_lost_table_comes_back() {
  finished_grid
  local table
  for table in accuracy.csv gains.csv quality.csv comparisons.csv ranks.csv decisions.csv confidence.csv recommendation.csv tables.md tables.tex summary.txt; do
    rm results/t/real/$table
    grid >/dev/null
    expect_equal "$(ran)" "1 tabulate"
    [[ -e results/t/real/$table ]] || fail "$table did not come back"
  done
}

test_cells_write_no_settings_of_tables() {
  describe
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=smote SEEDS=0 >/dev/null
  expect_equal "$(cd results/t/.settings && find . -type f | sort | xargs)" \
    "./datasets/real.toml ./diagnose.toml ./generate.toml ./score.toml ./split.toml ./train.smote.toml"
}

# The settings files of a run may be older than the programs: whole tables, as they stood.
test_settings_of_the_same_values_in_other_words_change_nothing() {
  finished_grid
  local header="# Made from pipeline/protocol.toml; edit that file, not this one."
  printf '%s\n' "$header" '[train]' 'epochs = 200' '[train.smote]' 'neighbours = 4' \
    >results/t/.settings/train.smote.toml
  printf '%s\n' "$header" '# Options given by make: --protocol random' '[split]' 'window = 1024' \
    >results/t/.settings/split.toml
  touch -d '1 hour ago' results/t/.settings/{train.smote,split}.toml
  grid >/dev/null
  expect_equal "$(ran)" ""
  sed -i 's/neighbours = 4/neighbours = 5/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
}

run_tests "$@"
