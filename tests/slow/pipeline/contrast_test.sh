#!/bin/bash
# Two protocols, and two readings of CWRU, side by side.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  local name
  for name in cwru cwru-as-published other; do
    printf 'name = "%s"\n' $name >pipeline/datasets/$name.toml
  done
  printf '[diagnose]\nepochs = 50\n' >pipeline/protocol.toml
}

contrast() {
  make --silent contrast BIN=fake RUN=t METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1" "$@"
}

test_makes_the_cells_of_both_protocols_and_the_table() {
  describe
  contrast DATASETS=other >/dev/null
  expect_equal "$(ran)" "1 contrast, 12 diagnose, 4 generate, 2 ingest, 4 score, 4 split, 4 train"
  expect_equal "$(<results/t/other/protocols.md)" \
    "contrast --with results/t/other --without results/t-blocked/other --methods none smote --ratios 100to1 10to1 --seeds 0 1 --output results/t/other/protocols.md"
  expect_line "$(<results/t/other/seed0/A.h5)" "--protocol random"
  expect_line "$(<results/t-blocked/other/seed0/A.h5)" "--protocol blocked"
}

test_shows_what_the_mixed_sample_rates_are_worth_where_both_are_asked_for() {
  describe
  contrast DATASETS=cwru >/dev/null
  [[ ! -e results/t/cwru-as-published ]] || fail "made what was not asked for"
  local shown
  shown=$(contrast DATASETS="cwru cwru-as-published")
  expect_equal "$(<results/t/cwru-as-published/rates.md)" \
    "contrast --with results/t/cwru-as-published --without results/t/cwru --methods none smote --ratios 100to1 10to1 --seeds 0 1 --output results/t/cwru-as-published/rates.md"
  expect_equal "$(grep -c '^contrast --with' <<<"$shown")" 3
}

test_asked_for_one_protocol_makes_both() {
  describe
  contrast DATASETS=other PROTOCOL=blocked >/dev/null
  expect_line "$(<results/t/other/protocols.md)" "--with results/t/other --without results/t-blocked/other"
}

test_is_of_all_that_both_runs_hold() {
  describe
  contrast DATASETS=other >/dev/null
  rm calls
  contrast DATASETS=other SEEDS=0 METHODS=none RATIOS=100to1 >/dev/null
  expect_equal "$(ran)" "1 contrast"
  expect_equal "$(<results/t/other/protocols.md)" \
    "contrast --with results/t/other --without results/t-blocked/other --methods none --ratios 100to1 --seeds 0 --output results/t/other/protocols.md"
}

test_leaves_out_what_is_out_of_date_on_either_side() {
  describe
  contrast DATASETS=other >/dev/null
  rm results/t-blocked/other/seed1/smote/E.h5
  contrast DATASETS=other SEEDS=0 >/dev/null
  expect_line "$(<results/t/other/protocols.md)" "--seeds 0 --leave-out seed1/smote --output"
  printf '[train.smote]\nneighbours = 3\n' >>pipeline/protocol.toml
  contrast DATASETS=other METHODS=none RATIOS=100to1 >/dev/null
  expect_line "$(<results/t/other/protocols.md)" "--leave-out seed0/smote seed1/smote --output"
}

test_makes_no_table_when_a_cell_fails() {
  describe
  echo "diagnose other/seed1/smote/10to1/wdcnn/diagnosis.h5" >broken
  expect_exit 2 contrast DATASETS=other
  [[ ! -e results/t/other/protocols.md ]] || fail "made a table with a hole"
}

run_tests "$@"
