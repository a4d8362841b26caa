#!/bin/bash
# What failures and signals leave of the grid, and how the holes are named.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

# A table stage that looks for its cells, as the real one does.
fussy_tabulate() {
  mkdir fake/lenient
  mv fake/tabulate fake/lenient
  ln -sf ../stage fake/lenient/tabulate
  cat >fake/tabulate <<'STAGE'
#!/bin/bash
[[ -f $2 ]] || { echo "tabulate: $2 was not readable" >&2 && exit 66; }
run=$4/$6 status=0 # --config FILE --run FOLDER --dataset NAME
for file in "$run"/seed{0,1}/{none/100to1/wdcnn/diagnosis,{smote,piae-dt}/{score,{10to1,1to1}/wdcnn/diagnosis}}.h5; do
  [[ -e $file ]] || { echo "tabulate: $file: missing" >&2 && status=66; }
done
((status)) && exit $status
exec fake/lenient/tabulate "$@"
STAGE
  chmod +x fake/tabulate
}

test_every_hole_is_named_and_the_other_cells_are_made() {
  describe
  fussy_tabulate
  echo "train real/seed1/smote/model.h5" >broken
  local output code=0
  output=$(grid -k -j2 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed1/smote +train: the reason$"
  expect_line "$output" "^real/seed1/smote +train +failed with exit code 65 after .*results/t/real/seed1/smote/train.log"
  expect_equal "$(sed -n 's/^real  *tabulate: \(.*\): missing/\1/p' <<<"$output")" \
    "$(printf 'results/t/real/seed1/smote/%s.h5\n' score {10to1,1to1}/wdcnn/diagnosis)"
  expect_no_line "$output" "^made .* missing"
  expect_equal "$(ran)" "22 diagnose, 7 generate, 1 ingest, 7 score, 1 simulate, 4 split, 1 tabulate, 7 train"
  [[ ! -e results/t/real/accuracy.csv ]] || fail "there is a table with holes"
  rm broken
  expect_exit 0 grid
  expect_equal "$(ran)" "2 diagnose, 1 generate, 1 score, 1 tabulate, 1 train"
}

test_the_holes_are_named_also_when_make_stops_at_the_first() {
  describe
  fussy_tabulate
  echo "score real/seed0/smote/score.h5" >broken
  local output code=0
  output=$(grid 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real +tabulate: results/t/real/seed0/smote/score.h5: missing"
  rm broken
  expect_exit 0 grid
  expect_equal "$(awk '{ print $2 }' calls | grep -c smote)" 22 # none of them twice
}

test_cells_that_could_not_be_made_again_are_holes() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  echo "train real/seed1/smote/model.h5" >broken
  grid -k >/dev/null 2>&1 || true
  local cell=results/t/real/seed1/smote
  expect_line "$(<results/t/real/accuracy.csv)" \
    " --outdated $cell/10to1/wdcnn/diagnosis.h5 --outdated $cell/1to1/wdcnn/diagnosis.h5 --outdated $cell/score.h5 --config "
  expect_no_line "$(<results/t/made/accuracy.csv)" "outdated"
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
  expect_no_line "$(<messages)" "not every cell"
}

test_what_is_written_when_make_is_stopped_stays() {
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

# 10 seeds of 14 cells: nobody wants to read their names.
test_without_recordings_the_data_set_says_so_and_no_cell_does() {
  describe
  fussy_tabulate
  echo "ingest real/records.h5" >broken
  local output code=0
  output=$(grid -k SEEDS="0 1 2 3 4 5 6 7 8 9" 2>&1) || code=$?
  expect_equal "$code" 2
  expect_equal "$(grep -c '^real .*the reason' <<<"$output")" 1
  expect_no_line "$output" "missing"
  expect_equal "$(grep -vc '^made' <<<"$output")" 9 # two of the step, the others make's own
  expect_equal "$(ran)" "60 diagnose, 20 generate, 20 score, 1 simulate, 10 split, 1 tabulate, 20 train"
}

run_tests "$@"
