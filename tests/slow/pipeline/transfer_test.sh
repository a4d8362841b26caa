#!/bin/bash
# Groups of data sets that test faults in another condition: their cells, a table and a picture each.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  cat >pipeline/figures/draw.sh <<'SCRIPT'
#!/bin/bash
touch "${1%.csv}.svg" "${1%.csv}.pdf"
SCRIPT
  local name
  for name in a b c other; do printf 'name = "%s"\n' $name >pipeline/datasets/$name.toml; done
  cat >pipeline/protocol.toml <<'TOML'
[transfer.first]
datasets = ["a", "b"]
against = "smote"
inputs = ["smote=wdcnn", "none=wdcnn-spectra"]
[transfer.second]
datasets = ["c"]
against = "smote"
inputs = ["smote=wdcnn"]
TOML
}

transfer() { make --silent transfer BIN=fake RUN=t SEEDS="0 1" "$@"; }

test_makes_the_cells_and_the_tables_of_all_groups() {
  describe
  local shown
  shown=$(transfer)
  # Three data sets of two seeds: none and smote, by five classifiers each.
  expect_equal "$(ran)" "60 diagnose, 6 generate, 3 ingest, 6 split, 6 train, 2 transfer"
  expect_equal "$(<results/t/transfer@first.md)" \
    "transfer --config results/t/.settings/transfer.first.toml --run results/t --group first --methods none smote --ratio 1to1 --classifiers $("$programs/settings" --facts | sed -nE 's/^classifier:(wdcnn|nearest)/\1/p' | xargs) --seeds 0 1"
  expect_line "$(<results/t/.settings/transfer.first.toml)" "inputs = \[ 'smote=wdcnn', 'none=wdcnn-spectra' \]"
  local file
  for file in transfer@first.{csv,md,svg,pdf} transfer-comparisons@first.csv transfer@second.{csv,svg}; do
    [[ -e results/t/$file ]] || fail "no $file"
  done
  [[ ! -e results/t/other ]] || fail "made what is in no group"
  expect_equal "$(grep -c '^transfer --config' <<<"$shown")" 2
  transfer >/dev/null
  expect_equal "$(ran)" ""
}

test_is_of_the_groups_whose_data_sets_are_all_asked_for() {
  describe
  transfer DATASETS="a b" METHODS="none smote" CLASSIFIERS="wdcnn wdcnn-spectra" RATIOS="100to1 10to1 5to1" >/dev/null
  # At one ratio alone; and none has its cell of nearest.
  expect_equal "$(ran)" "20 diagnose, 4 generate, 2 ingest, 4 split, 4 train, 1 transfer"
  expect_line "$(<results/t/transfer@first.md)" "--ratio 5to1 --classifiers wdcnn wdcnn-spectra "
  expect_equal "$(cd results/t/a/seed0/smote && echo *to1)" 5to1
  expect_line "$(transfer DATASETS=a 2>&1)" 'DATASETS must have all of a group: first \(a b\) second \(c\)'
  expect_line "$(transfer RATIOS=100to1 2>&1)" 'RATIOS must have others than 100to1'
}

test_classifiers_without_a_recorded_input_are_refused_before_any_cell() {
  describe
  expect_line "$(transfer CLASSIFIERS="wdcnn nearest" 2>&1)" \
    'make transfer: CLASSIFIERS must have wdcnn-spectra, which \[transfer.first\] of pipeline/protocol.toml names'
  expect_exit 2 transfer CLASSIFIERS="wdcnn nearest"
  expect_equal "$(ran)" ""
  transfer CLASSIFIERS="wdcnn nearest" METHODS=smote >/dev/null
  sed -i '/^inputs = \["smote=wdcnn"\]/a kind-inputs = ["smote=wdcnn-envelope"]' pipeline/protocol.toml
  expect_line "$(transfer DATASETS=c CLASSIFIERS=wdcnn 2>&1)" "must have wdcnn-envelope, which"
}

test_another_choice_makes_the_table_again_and_no_cell() {
  describe
  transfer >/dev/null
  ran >/dev/null
  sed -i 's/"none=wdcnn-spectra"/"none=wdcnn"/' pipeline/protocol.toml
  transfer >/dev/null
  expect_equal "$(ran)" "1 transfer"
  transfer SEEDS=0 >/dev/null
  expect_equal "$(ran)" "2 transfer"
  expect_line "$(<results/t/transfer@first.md)" "--seeds 0$"
}

test_is_of_the_protocol_that_is_asked_for() {
  describe
  transfer DATASETS=c PROTOCOL=blocked >/dev/null
  expect_line "$(<results/t-blocked/transfer@second.md)" "--run results/t-blocked --group second"
  expect_line "$(<results/t-blocked/c/seed0/A.h5)" "--protocol blocked"
}

test_makes_no_table_when_a_cell_fails() {
  describe
  echo "diagnose b/seed1/smote/1to1/wdcnn/diagnosis.h5" >broken
  expect_exit 2 transfer -k
  [[ ! -e results/t/transfer@first.md ]] || fail "made a table with a hole"
  [[ -e results/t/transfer@second.md ]] || fail "the other group has no table"
}

test_a_data_set_that_there_is_not_is_refused_with_its_line() {
  describe
  rm pipeline/datasets/b.toml
  expect_line "$(transfer 2>&1)" "protocol.toml, line 2: transfer.first.datasets holds 'b', and there is no pipeline/datasets/b.toml"
  expect_exit 2 transfer
  # All else goes on.
  make --silent cells BIN=fake RUN=t DATASETS=other METHODS=none RATIOS=100to1 SEEDS=0 >/dev/null
}

test_no_group_is_refused() {
  describe
  echo >pipeline/protocol.toml
  expect_line "$(transfer 2>&1)" '\[transfer\] of pipeline/protocol.toml names no group'
}

# What looks at a run, or submits it, knows nothing of it, and says so.
test_status_and_a_cluster_do_not_know_it() {
  describe
  expect_line "$(make --silent status transfer BIN=fake RUN=t 2>&1)" "one of .* at a time, not 'transfer'"
  expect_line "$(make --silent cluster-plan transfer BIN=fake RUN=t 2>&1)" "one of .* at a time, not 'transfer'"
  transfer >/dev/null
  expect_line "$(make --silent status BIN=fake RUN=t DATASETS="a b c" METHODS="none smote" RATIOS="100to1 1to1" SEEDS="0 1" 2>&1)" '.'
}

run_tests "$@"
