#!/bin/bash
# Goals for single questions: contrast, sweep, readings, identify, transfer, trust, verdicts. tests/plan tests their steps in
# process; here make runs them, shows their tables, and does nothing a second time.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  local name
  for name in real other; do printf 'name = "%s"\n' $name >pipeline/datasets/$name.toml; done
  printf 'name = "made"\n[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ntouch "${1%%.csv}.svg" "${1%%.csv}.pdf"\n' >pipeline/figures/draw.sh
  cat >pipeline/protocol.toml <<'TOML'
[train]
[train.piae-dt]
batch = 5      # a comment
depth = 3
[train.smote]
neighbours = 4
[diagnose]
epochs = 50
[sweep]
points = ["batch=1", "batch=5", "depth=2", "depth=3"]
[sweep.smote]
classifier = "wdcnn-spectra"
points = ["neighbours=1", "neighbours=4"]
[readings]
base = ["batches=mixed", "space=all"]
readings = ["batches=class", "batches=class+space=class"]
[transfer.first]
datasets = ["real", "other"]
against = "smote"
inputs = ["smote=wdcnn", "none=wdcnn-spectra"]
TOML
}

ask() { make --silent BIN=fake RUN=t "$@"; }
# Makes a goal twice and prints what ran first. The words after the goal are variables.
twice() { # goal, variables...
  ask "$@" >shown 2>&1 || fail "$(<shown)"
  local first
  first=$(ran)
  ask "$@" >/dev/null
  expect_equal "$(ran)" ""
  echo "$first"
}

test_a_contrast_uses_both_protocols_and_the_papers_classifier() {
  describe
  local which=(contrast DATASETS=other METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1")
  expect_equal "$(twice "${which[@]}")" "1 contrast, 8 diagnose, 4 generate, 2 ingest, 4 score, 4 split, 4 train"
  expect_equal "$(command_of other/contrast)" \
    "fake/contrast --with results/t/other --without results/t-blocked/other --methods none smote --ratios 100to1 10to1 --seeds 0 1 --output results/t/other/protocols.md"
  expect_equal "$(tail -n 1 shown)" "$(<results/t/other/protocols.md)"
  ask "${which[@]}" PROTOCOL=blocked >/dev/null
  expect_equal "$(ran)" ""
}

test_a_contrast_of_two_readings_of_cwru_compares_their_rates() {
  describe
  local name
  for name in cwru cwru-as-published; do printf 'name = "%s"\n' $name >pipeline/datasets/$name.toml; done
  expect_line "$(twice contrast DATASETS="cwru cwru-as-published" METHODS=smote RATIOS=10to1 SEEDS=0)" '^3 contrast, '
  expect_line "$(command_of cwru-as-published/contrast@rates)" \
    "--with results/t/cwru-as-published --without results/t/cwru --methods smote .*/rates.md$"
}

# Four points of two settings; one point of each setting is the method itself.
test_sweeps_share_cells_with_the_grid() {
  describe
  ask cells DATASETS=real SEEDS=0 METHODS="none piae-dt" RATIOS="10to1 1to1" >/dev/null
  rm calls
  local which=(sweep DATASETS=real SEEDS=0 METHODS="piae-dt smote")
  expect_equal "$(twice "${which[@]}" -j4)" "4 diagnose, 4 generate, 4 score, 2 sweep, 4 train"
  expect_equal "$(cd results/t/real/seed0/ && echo sweep*/*)" "sweep/batch-1 sweep/depth-2 sweep@smote/neighbours-1"
  expect_equal "$(command_of real/seed0/sweep/batch-1/train)" \
    "fake/train --config results/t/.settings/train.piae-dt.toml --known results/t/real/seed0/C.h5 --method piae-dt --seed 0 --batch 1 --output results/t/real/seed0/sweep/batch-1/model.h5"
  expect_equal "$(grep -c '^sweep --config' shown)" 2
  sed -i 's/# a comment/# another/' pipeline/protocol.toml
  ask "${which[@]}" >/dev/null
  expect_equal "$(ran)" ""
}

test_a_failed_cell_of_a_sweep_is_named_and_its_table_missing() {
  describe
  echo "train real/seed0/sweep/depth-2/model.h5" >broken
  local output code=0
  output=$(ask -k sweep DATASETS=real SEEDS=0 METHODS=piae-dt 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed0/sweep/depth-2 +train +failed with exit code 65"
  expect_equal "$(ran)" "2 diagnose, 2 generate, 1 ingest, 2 score, 1 split, 2 train"
  rm broken
  ask sweep DATASETS=real SEEDS=0 METHODS=piae-dt >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 score, 1 sweep, 1 train"
}

test_readings_are_ranked_and_drawn_in_a_separate_run() {
  describe
  expect_equal "$(make -n readings BIN=fake DATASETS=real | grep -oE 'results/[a-z]+/real/seed[0-9]+' | sort -u | xargs)" \
    "$(echo results/readings/real/seed10{0,1,2,3,4})"
  expect_equal "$(twice readings DATASETS=real SEEDS=100)" \
    "6 diagnose, 3 generate, 1 ingest, 1 readings, 3 score, 1 split, 3 train"
  expect_equal "$(tail -n 2 shown)" " 60.00  batches=class
 50.00  base"
  expect_equal "$(cd results/t/real/seed100/readings && echo *)" "base batches-class batches-class+space-class"
  [[ -e results/t/real/readings.svg ]] || fail "no picture"
}

test_an_identification_uses_simulated_data_sets() {
  describe
  expect_equal "$(twice identify DATASETS=made METHODS="smote piae-dt" SEEDS="0 1")" "1 identify, 1 simulate, 2 split, 2 train"
  expect_line "$(command_of made/identify)" "--run results/t --dataset made --methods piae-dt --seeds 0 1"
}

test_a_transfer_averages_groups_at_one_ratio() {
  describe
  # Two data sets with two seeds: none by three classifiers, smote by two.
  expect_equal "$(twice transfer DATASETS="real other" METHODS="none smote" CLASSIFIERS="wdcnn wdcnn-spectra" \
    RATIOS="100to1 10to1 5to1" SEEDS="0 1")" "20 diagnose, 4 generate, 2 ingest, 4 split, 4 train, 1 transfer"
  local file
  for file in transfer@first.{csv,md,svg,pdf} transfer-comparisons@first.csv; do
    [[ -e results/t/$file ]] || fail "no $file"
  done
  echo "diagnose other/seed1/smote/5to1/wdcnn/diagnosis.h5" >broken
  rm -r results/t/transfer@first.md results/t/other/seed1/smote/5to1/wdcnn
  expect_exit 2 ask transfer -k DATASETS="real other" METHODS="none smote" CLASSIFIERS="wdcnn wdcnn-spectra" RATIOS=5to1 SEEDS="0 1"
  [[ ! -e results/t/transfer@first.md ]] || fail "made a table with a hole"
}

test_no_other_goal_keeps_classifiers() {
  describe
  local which=(DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1")
  ask all "${which[@]}" >/dev/null
  expect_equal "$(find results -name classifier.h5)" ""
  cp -r results before
  rm calls
  expect_equal "$(twice trust "${which[@]}")" "6 keep, 1 trust"
  expect_equal "$(diff -rq before results | grep -vE 'Only in results|Only in .*: classifier|/\.journal ' || true)" ""
  expect_equal "$(cd results/t/real && echo seed0/*/*/*/classifier.h5)" \
    "seed0/none/100to1/nearest/classifier.h5 seed0/none/100to1/wdcnn/classifier.h5 seed0/smote/10to1/wdcnn/classifier.h5"
  expect_equal "$(tail -n 1 shown)" "$(<results/t/real/trust.md)"
  ask all "${which[@]}" >/dev/null
  expect_equal "$(ran)" ""
}

test_verdicts_judge_all_records_by_each_kept_classifier() {
  describe
  local which=(DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1" CLASSIFIERS=wdcnn)
  ask trust "${which[@]}" >/dev/null
  rm calls
  expect_equal "$(twice verdicts "${which[@]}")" "6 classify, 1 verdicts"
  expect_equal "$(tail -n 1 shown)" "$(<results/t/real/verdicts.md)"
  [[ -e results/t/real/verdicts.svg ]] || fail "no picture"
  rm results/t/real/seed0/none/100to1/nearest/classifier.h5
  expect_equal "$(twice verdicts "${which[@]}")" "1 keep"
}

test_impossible_requests_are_refused_before_any_cell() {
  describe
  expect_line "$(ask sweep DATASETS=real METHODS=dynamics 2>&1)" "^plan: make sweep: METHODS must include one of piae-dt smote, "
  expect_line "$(ask transfer DATASETS=real 2>&1)" 'DATASETS must include all data sets of one group: first \(real other\)'
  sed -i 's/"depth=2"/"dept=2"/' pipeline/protocol.toml
  expect_line "$(ask sweep DATASETS=real 2>&1)" "pipeline/protocol.toml, line 10: .*'dept=2'"
  sed -i 's/"dept=2"/"depth=2"/' pipeline/protocol.toml
  rm pipeline/datasets/other.toml
  expect_line "$(ask transfer DATASETS=real 2>&1)" \
    "protocol.toml, line 18: transfer.first.datasets holds 'other', but there is no pipeline/datasets/other.toml"
  expect_exit 2 ask transfer DATASETS=real
  expect_equal "$(ran)" ""
  ask cells DATASETS=real METHODS=none RATIOS=100to1 SEEDS=0 >/dev/null # everything else still runs
}

run_tests "$@"
