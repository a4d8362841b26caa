#!/bin/bash
# Failures and signals leave missing cells in the grid, which are named.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

test_missing_cells_are_named_and_the_others_made() {
  describe
  echo "train real/seed1/smote/model.h5" >broken
  local output code=0
  output=$(grid -k -j2 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed1/smote +train: the reason$"
  expect_line "$output" "^real/seed1/smote +train +failed with exit code 65 after .*results/t/real/seed1/smote/train.log"
  expect_line "$output" "^real/seed1/smote train: missing$"
  expect_line "$output" "^real/seed1/smote/1to1/wdcnn diagnose: missing$"
  expect_line "$output" "^real tabulate: missing$"
  expect_no_line "$output" "^made .* missing"
  expect_equal "$(ran)" "22 diagnose, 7 generate, 1 ingest, 7 score, 1 simulate, 4 split, 1 tabulate, 7 train"
  [[ ! -e results/t/real/accuracy.csv ]] || fail "there is a table with holes"
  expect_line "$(<reports)" "--datasets real made"
  rm broken
  expect_exit 0 grid
  expect_equal "$(ran)" "2 diagnose, 1 generate, 1 score, 1 tabulate, 1 train"
}

test_missing_cells_are_named_if_make_stops_at_the_first() {
  describe
  echo "score real/seed0/smote/score.h5" >broken
  local output code=0
  output=$(grid 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed0/smote score and 3 more: missing$"
  rm broken
  expect_exit 0 grid
  expect_equal "$(awk '{ print $2 }' calls | grep -c smote)" 22 # none twice
}

# 10 seeds of 14 cells are too many names to print.
test_missing_recordings_are_reported_in_few_lines() {
  describe
  echo "ingest real/records.h5" >broken
  local output code=0
  output=$(grid -k SEEDS="0 1 2 3 4 5 6 7 8 9" 2>&1) || code=$?
  expect_equal "$code" 2
  expect_equal "$(grep -c '^real .*the reason' <<<"$output")" 1
  expect_line "$output" "^real/seed0 split and 9 more: missing$"
  expect_equal "$(ran)" "60 diagnose, 20 generate, 20 score, 1 simulate, 10 split, 1 tabulate, 20 train"
}

test_a_signal_to_make_all_reaches_the_stage() {
  describe
  rm fake/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ntrap "touch saved; exit 75" TERM\ntouch started\nwhile :; do sleep 0.05; done\n' >fake/train
  chmod +x fake/train
  set -m
  make --silent all BIN=fake DATASETS=real METHODS=piae-dt SEEDS=0 >messages 2>&1 &
  set +m
  wait_for started
  kill -TERM $!
  expect_exit 143 wait $!
  wait_for saved
  expect_no_line "$(<messages)" "some steps failed"
}

test_outputs_stay_if_make_is_stopped() {
  describe
  rm fake/train
  # shellcheck disable=SC2016
  printf '%s\n' '#!/bin/bash' 'trap "" TERM' 'while (($#)); do [[ $1 != --output ]] || echo made >"$2"; shift; done' \
    'touch written' 'sleep 1' >fake/train
  chmod +x fake/train
  set -m
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=piae-dt SEEDS=0 >messages 2>&1 &
  set +m
  wait_for written
  kill -TERM $!
  expect_exit 143 wait $!
  expect_equal "$(<results/t/real/seed0/piae-dt/model.h5)" made
  expect_no_line "$(<messages)" Deleting
}

run_tests "$@"
