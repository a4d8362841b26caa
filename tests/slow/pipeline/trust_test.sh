#!/bin/bash
# Classifiers that are kept, and the tables that say how far to believe them.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

here=results/t/real
describe() { echo 'name = "real"' >pipeline/datasets/real.toml; }
trust() { make --silent trust BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1" "$@"; }
kept() { (cd $here && find . -name classifier.h5 | LC_ALL=C sort | xargs); }

test_keeps_the_classifiers_of_the_cells_that_are_asked_for() {
  describe
  expect_equal "$(trust | tail -n 1)" "$(<$here/trust.md)"
  local seed cells=()
  for seed in 0 1; do cells+=("./seed$seed"/{none/100to1/{nearest,wdcnn},smote/10to1/wdcnn}/classifier.h5); done
  expect_equal "$(kept)" "${cells[*]}"
  expect_equal "$(grep -c '^keep' calls)" 6
  expect_equal "$(grep -c '^trust' calls)" 1
  expect_equal "$(grep -c '^diagnose' calls || true)" 0
  local s=results/t/.settings
  local windows="--test $here/seed1/A.h5 --normal $here/seed1/B.h5 --known $here/seed1/C.h5"
  expect_equal "$(<$here/seed1/smote/10to1/wdcnn/classifier.h5)" \
    "diagnose --config $s/diagnose.toml $windows --generated $here/seed1/smote/E.h5 --ratio 10to1 --seed 1 --keep-classifier $here/seed1/smote/10to1/wdcnn/classifier.h5"
  expect_equal "$(<$here/seed1/none/100to1/wdcnn/classifier.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 100to1 --seed 1 --keep-classifier $here/seed1/none/100to1/wdcnn/classifier.h5"
  expect_equal "$(tr -s ' ' <$here/trust.md)" \
    "trust --config $s/trust.real.toml --run results/t --dataset real --methods none smote --ratios 100to1 10to1 --seeds 0 1 --classifiers wdcnn"
}

test_does_nothing_a_second_time() {
  describe
  trust >/dev/null
  rm calls
  trust >/dev/null
  [[ ! -e calls ]] || fail "ran: $(<calls)"
}

# Gigabytes, and five trainings a cell, unasked.
test_a_grid_without_it_keeps_none() {
  describe
  make --silent all BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1" >/dev/null
  expect_equal "$(kept)" ""
  expect_equal "$(grep -cE '^(keep|trust)' calls || true)" 0
  cp -r results before
  rm calls
  trust >/dev/null
  expect_equal "$(awk '{ print $1 }' calls | sort | uniq -c | xargs)" "6 keep 1 trust"
  # And what the grid holds stays as it was.
  expect_equal "$(diff -r before results | grep -vE 'Only in results|Only in .*: classifier' || true)" ""
  rm calls
  make --silent all BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS="0 1" >/dev/null
  expect_equal "$(grep -cE '^(keep|trust|diagnose|tabulate)' calls 2>/dev/null || true)" ""
}

# The baseline has the nearest neighbour, too.
test_each_classifier_has_a_folder() {
  describe
  trust SEEDS=0 CLASSIFIERS="wdcnn exclusion-rule wdcnn-spectrum" >/dev/null
  expect_equal "$(kept)" \
    "$(echo ./seed0/{none/100to1/{exclusion-rule,nearest,wdcnn-spectrum,wdcnn},smote/10to1/{wdcnn-spectrum,wdcnn}}/classifier.h5)"
  expect_line "$(<$here/seed0/smote/10to1/wdcnn-spectrum/classifier.h5)" "--ratio 10to1 --classifier wdcnn-spectrum --seed 0 --keep-classifier"
  expect_line "$(<$here/trust.md)" "--classifiers wdcnn exclusion-rule wdcnn-spectrum"
}

test_a_setting_keeps_them_again() {
  describe
  trust SEEDS=0 >/dev/null
  rm calls
  sed -i '/^\[diagnose\]/,/^\[/s/^epochs = .*/epochs = 7/' pipeline/protocol.toml
  trust SEEDS=0 >/dev/null
  expect_equal "$(awk '{ print $1 }' calls | sort | uniq -c | xargs)" "3 keep 1 trust"
}

# The tables are of what was asked for, so another choice makes them again.
test_tables_are_of_the_cells_that_are_asked_for() {
  describe
  trust >/dev/null
  rm calls
  trust SEEDS=1 >/dev/null
  expect_equal "$(<calls)" "trust real"
  expect_line "$(<$here/trust.md)" "--seeds 1 "
}

test_a_classifier_that_fails_leaves_no_table() {
  describe
  echo 'diagnose real/seed1/smote/10to1/wdcnn/classifier.h5' >broken
  local said
  said=$(trust 2>&1 || true)
  expect_line "$said" 'diagnose: the reason'
  [[ ! -e $here/trust.md ]] || fail "there is a table"
  [[ ! -e $here/seed1/smote/10to1/wdcnn/classifier.h5 ]] || fail "there is a classifier"
}

run_tests "$@"
