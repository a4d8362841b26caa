#!/bin/bash
# The sweep as a graph: one setting at a time, the common point computed once, changes and failures.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  printf 'name = "real"\n' >pipeline/datasets/real.toml
  cat >pipeline/protocol.toml <<'TOML'
[train]
[train.piae-dt]
batch = 5      # a comment
depth = 3
loss-weights = "adaptive"
learning-rate = 5e-4
[train.smote]
neighbours = 4
[diagnose]
epochs = 50
[sweep]
points = [
  "batch=1", "batch=2", "batch=5", "batch=10", "batch=20",
  "depth=1", "depth=2", "depth=3", "depth=4", "depth=5", "depth=6",
  "loss-weights=adaptive", "loss-weights=adaptive-without-log", "loss-weights=fixed",
  "learning-rate=1e-4", "learning-rate=2e-4", "learning-rate=0.0005", "learning-rate=1e-3",
]
[train.strike-twin]
tilt = 0
[sweep.strike-twin]
classifier = "wdcnn-spectra"
points = ["edges=known", "tilt=0", "background=0"]
TOML
}

sweep() { make --silent sweep BIN=fake RUN=t DATASETS=real SEEDS=0 "$@"; }
parts() { sweep METHODS=strike-twin "$@"; }

finished_sweep() {
  describe
  sweep >/dev/null 2>&1
  rm calls
}

# 5 + 6 + 3 + 4 points, of which four are the method as it is, 0.0005 and 5e-4 being one: 15 cells.
test_makes_every_point_once_and_the_common_one_with_them() {
  describe
  sweep -j4 >/dev/null
  expect_equal "$(ran)" "15 diagnose, 15 generate, 1 ingest, 15 score, 1 split, 1 sweep, 15 train"
  expect_equal "$(cd results/t/real/seed0/sweep && echo *)" \
    "batch-1 batch-10 batch-2 batch-20 depth-1 depth-2 depth-4 depth-5 depth-6 learning-rate-1e-3 learning-rate-1e-4 learning-rate-2e-4 loss-weights-adaptive-without-log loss-weights-fixed"
}

test_moves_one_setting() {
  finished_sweep
  local r=results/t/real s=results/t/.settings c=results/t/real/seed0/sweep/loss-weights-fixed
  expect_equal "$(<$c/model.h5)" \
    "train --config $s/train.piae-dt.toml --method piae-dt --loss-weights fixed --known $r/seed0/C.h5 --seed 0 --output $c/model.h5"
  expect_equal "$(<$c/E.h5)" "generate --config $s/generate.toml --model $c/model.h5 --seed 0 --output $c/E.h5"
  expect_line "$(<$c/1to1/wdcnn/diagnosis.h5)" "--generated $c/E.h5 --ratio 1to1 --seed 0"
  expect_no_line "$(<$r/seed0/piae-dt/model.h5)" "--batch|--depth|--loss-weights|--learning-rate"
}

test_tells_the_table_its_points_and_which_are_common() {
  finished_sweep
  expect_equal "$(grep -cE "^ +'(batch|depth|loss-weights|learning-rate)=[a-z0-9.-]+',?$" results/t/.settings/sweep.real.toml)" 18
  expect_equal "$(<results/t/real/sweep.csv)" \
    "sweep --config results/t/.settings/sweep.real.toml --run results/t --dataset real --centre batch=5 --centre depth=3 --centre loss-weights=adaptive --centre learning-rate=0.0005 --ratios 1to1 --seeds 0"
}

test_shares_cells_with_the_grid() {
  describe
  make --silent cells BIN=fake RUN=t DATASETS=real SEEDS=0 METHODS="none piae-dt" RATIOS="10to1 1to1" >/dev/null
  rm calls
  sweep >/dev/null
  expect_equal "$(ran)" "14 diagnose, 14 generate, 14 score, 1 sweep, 14 train"
}

test_second_run_does_nothing() {
  finished_sweep
  sed -i 's/# a comment/# another/' pipeline/protocol.toml
  sweep >/dev/null
  expect_equal "$(ran)" ""
}

test_ratios_and_seeds_add_what_is_missing() {
  finished_sweep
  sweep RATIOS="100to1 10to1 1to1" >/dev/null
  expect_equal "$(ran)" "15 diagnose, 1 sweep"
  sweep SEEDS="0 1" >/dev/null
  expect_equal "$(ran)" "15 diagnose, 15 generate, 15 score, 1 split, 1 sweep, 15 train"
}

test_a_part_leaves_the_table_of_the_whole() {
  describe
  sweep SEEDS="0 1" RATIOS="10to1 1to1" >/dev/null
  rm calls
  sweep >/dev/null
  expect_equal "$(ran)" ""
  rm -r results/t/real/seed1/sweep/depth-6
  sweep >/dev/null
  expect_equal "$(ran)" "1 sweep"
}

test_what_is_out_of_date_and_not_asked_for_is_left_out_of_the_table() {
  describe
  sweep SEEDS="0 1" >/dev/null
  rm calls results/t/real/seed1/sweep/depth-6/E.h5
  sweep >/dev/null
  expect_equal "$(ran)" "1 sweep"
  expect_line "$(<results/t/real/sweep.csv)" "--leave-out seed1/sweep/depth-6 --centre"
}

test_a_setting_of_the_method_remakes_the_sweep() {
  finished_sweep
  sed -i 's/depth = 3/depth = 4/' pipeline/protocol.toml
  sweep >/dev/null
  expect_equal "$(ran)" "15 diagnose, 15 generate, 15 score, 1 sweep, 15 train"
  expect_line "$(<results/t/real/sweep.csv)" "--centre depth=4 "
  sed -i 's/neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  sweep >/dev/null
  expect_equal "$(ran)" ""
}

test_a_protocol_value_that_is_no_point_has_a_cell_of_each_point() {
  describe
  sed -i 's/batch = 5/batch = 7/' pipeline/protocol.toml
  sweep >/dev/null
  expect_equal "$(ran)" "16 diagnose, 16 generate, 1 ingest, 16 score, 1 split, 1 sweep, 16 train"
  expect_no_line "$(<results/t/real/sweep.csv)" "--centre batch"
}

test_a_failed_cell_is_named_and_leaves_the_others() {
  describe
  echo "train real/seed0/sweep/depth-6/model.h5" >broken
  local output code=0
  output=$(sweep -k 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed0/sweep/depth-6 +train +failed with exit code 65"
  expect_equal "$(ran)" "14 diagnose, 14 generate, 1 ingest, 14 score, 1 split, 14 train"
  rm broken
  sweep >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 score, 1 sweep, 1 train"
}

test_the_grid_does_not_run_the_sweep() {
  describe
  make --silent cells BIN=fake RUN=t DATASETS=real SEEDS=0 METHODS=piae-dt RATIOS=1to1 >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 train"
}

test_what_cannot_be_is_refused() {
  describe
  expect_line "$(sweep METHODS=smote 2>&1 || true)" "moves the settings of piae-dt strike-twin: METHODS must have one of them"
  expect_line "$(sweep RATIOS=100to1 2>&1 || true)" "RATIOS"
  expect_exit 2 sweep RATIOS=100to1
  sed -i 's/"background=0"/"backgrund=0"/' pipeline/protocol.toml
  expect_line "$(sweep 2>&1 || true)" "pipeline/protocol.toml, line 22: .*'backgrund=0', but of strike-twin there is no"
}

# Of three points one is the method as it is, which the table has in any case.
test_parts_of_another_method_have_folders_and_tables_of_their_own() {
  describe
  parts -j4 >/dev/null
  expect_equal "$(ran)" "3 diagnose, 3 generate, 1 ingest, 3 score, 1 split, 1 sweep, 3 train"
  local r=results/t/real s=results/t/.settings c=results/t/real/seed0/sweep@strike-twin/edges-known
  expect_equal "$(<$c/model.h5)" \
    "train --config $s/train.strike-twin.toml --method strike-twin --edges known --healthy $r/seed0/B.h5 --known $r/seed0/C.h5 --seed 0 --output $c/model.h5"
  expect_line "$(<$c/1to1/wdcnn-spectra/diagnosis.h5)" "--generated $c/E.h5 --ratio 1to1 --classifier wdcnn-spectra --seed 0"
  expect_line "$(<$r/seed0/strike-twin/1to1/wdcnn-spectra/diagnosis.h5)" "--classifier wdcnn-spectra --seed 0"
  expect_equal "$(<$r/sweep@strike-twin.md)" \
    "sweep --config $s/sweep@strike-twin.real.toml --run results/t --dataset real --method strike-twin --centre tilt=0 --ratios 1to1 --seeds 0"
  expect_line "$(<$s/sweep@strike-twin.real.toml)" "^classifier = 'wdcnn-spectra'$"
  [[ ! -e $r/sweep.md && ! -e $r/sweep.log && -e $r/sweep@strike-twin.log ]] || fail "$(ls $r)"
}

test_sweeps_of_several_methods_are_one_run() {
  describe
  local output
  output=$(sweep METHODS="none smote piae-dt strike-twin" -j4)
  expect_equal "$(ran)" "18 diagnose, 18 generate, 1 ingest, 18 score, 1 split, 2 sweep, 18 train"
  expect_line "$output" "^sweep .* --dataset real --centre batch=5 "
  expect_line "$output" "^sweep .* --dataset real --method strike-twin "
  sweep METHODS="piae-dt strike-twin" >/dev/null
  parts >/dev/null
  sweep >/dev/null
  expect_equal "$(ran)" ""
}

test_parts_share_cells_with_the_grid() {
  describe
  make --silent cells BIN=fake RUN=t DATASETS=real SEEDS=0 METHODS="none strike-twin" RATIOS="100to1 1to1" \
    CLASSIFIERS="wdcnn wdcnn-spectra" >/dev/null
  rm calls
  parts >/dev/null
  expect_equal "$(ran)" "2 diagnose, 2 generate, 2 score, 1 sweep, 2 train"
  parts CLASSIFIERS=wdcnn-spectra >/dev/null
  expect_equal "$(ran)" ""
}

test_a_part_of_the_parts_leaves_the_table_of_the_whole() {
  describe
  parts SEEDS="0 1" >/dev/null
  rm calls
  parts >/dev/null
  expect_equal "$(ran)" ""
  rm results/t/real/seed1/sweep@strike-twin/edges-known/E.h5
  parts >/dev/null
  expect_equal "$(ran)" "1 sweep"
  expect_line "$(<results/t/real/sweep@strike-twin.md)" "--leave-out seed1/sweep@strike-twin/edges-known --method"
  sed -i 's/"edges=known", //' pipeline/protocol.toml
  parts SEEDS="0 1" >/dev/null
  expect_equal "$(ran)" "1 sweep"
}

test_another_classifier_judges_anew() {
  describe
  parts >/dev/null
  rm calls
  sed -i 's/"wdcnn-spectra"/"wdcnn"/' pipeline/protocol.toml
  parts >/dev/null
  expect_equal "$(ran)" "3 diagnose, 1 sweep"
  [[ -e results/t/real/seed0/sweep@strike-twin/edges-known/1to1/wdcnn/diagnosis.h5 ]] || fail "no diagnosis by wdcnn"
}

run_tests "$@"
