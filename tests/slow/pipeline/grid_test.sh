#!/bin/bash
# make must run exactly what the plan prints. tests/plan tests the steps and when they are due.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

test_makes_every_cell_once_and_then_nothing() {
  describe
  local output
  output=$(grid -j4)
  expect_equal "$(ran_with_features)" \
    "24 diagnose, 6 features, 8 generate, 1 ingest, 8 score, 1 simulate, 4 split, 2 tabulate, 8 train"
  expect_equal "$(tail -n 1 <<<"$output")" "tables and artefacts: results/t/real/ results/t/made/"
  expect_line "$output" "^tabulate --config results/t/.settings/tabulate.toml --run results/t --dataset made " # its summary
  expect_equal "$(tr -s ' ' <reports | sed 's/ $//')" \
    "report: --run results/t --datasets real made --methods none smote piae-dt --ratios 100to1 10to1 1to1 --seeds 0 1 --classifiers wdcnn --published results/published"
  find results pipeline fake/ -exec touch {} + # file times do not count
  grid >/dev/null
  expect_equal "$(ran)" ""
  expect_exit 0 make --silent -q cells BIN=fake RUN=t DATASETS=real METHODS=smote SEEDS=0 RATIOS=1to1
}

test_read_only_goals_write_nothing() {
  describe
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 62
  expect_exit 1 grid -q
  expect_line "$(make --silent why BIN=fake RUN=t DATASETS=real)" '^real ingest: missing$'
  expect_line "$(make --silent plan BIN=fake RUN=t DATASETS=real SEEDS=0)" '^[0-9]+ steps: '
  [[ ! -e results/t ]] || fail "there is $(find results/t)"
  grid >/dev/null
  rm calls
  find results -printf '%p %T@ %s\n' >before
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 34 # 24 diagnoses, 6 with features, 2 of tables, 2 of figures
  expect_line "$(make --silent why BIN=fake RUN=t 2>&1)" "DATASETS: unknown 'cwru'"
  expect_line "$(make --silent why all BIN=fake RUN=t DATASETS=made SEEDS="0 1" METHODS=smote)" \
    '^made/seed0/smote/10to1/wdcnn diagnose and 3 more: setting epochs is 60, was 50$'
  expect_equal "$(find results -printf '%p %T@ %s\n')" "$(<before)"
  expect_equal "$(ran)" ""
}

test_a_changed_setting_remakes_its_dependents() {
  finished_grid
  sed -i 's/# samples/# of 12 kHz/; s/^  3,/  4,/' pipeline/protocol.toml
  grid >/dev/null
  expect_no_line "$(<calls)" "smote|none"
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
  expect_equal "$(grep -v '^#' results/t/.settings/train.piae-dt.toml)" $'depth = [ 4 ]\nepochs = 200'
  expect_line "$(command_of real/seed0/piae-dt/train)" '--config results/t/.settings/train.piae-dt.toml '
}

# The contents are unchanged, so nothing downstream is remade.
test_only_a_lost_file_is_remade() {
  finished_grid
  local file
  for file in seed0/D.h5:split seed0/smote/model.h5:train seed1/smote/E.h5:generate tables.md:tabulate records.h5:ingest; do
    rm "results/t/real/${file%:*}"
    grid >/dev/null
    expect_equal "$(ran)" "1 ${file#*:}"
    [[ -e results/t/real/${file%:*} ]] || fail "${file%:*} did not come back"
  done
}

test_a_damaged_file_is_remade() {
  finished_grid
  printf x | dd of=results/t/made/seed0/smote/score.h5 bs=1 seek=700 conv=notrunc status=none
  grid >/dev/null
  expect_equal "$(ran)" "1 score"
  echo edited >>results/t/made/tables.md
  grid >/dev/null
  expect_equal "$(ran)" "1 tabulate"
}

test_the_journal_is_rebuilt_from_the_artefacts() {
  finished_grid
  rm results/t/.journal
  grid >/dev/null
  expect_equal "$(ran)" "2 tabulate"
  cp -r results/t results/copy
  rm -r results/t
  mv results/copy results/t
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_tables_cover_the_whole_run_without_stale_cells() {
  finished_grid
  grid SEEDS=0 DATASETS=real METHODS="none smote" >/dev/null
  expect_equal "$(ran)" ""
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  grid METHODS="none piae-dt" >/dev/null
  expect_equal "$(ran)" "2 tabulate"
  expect_line "$(<results/t/real/tables.md)" " --leave-out seed0/smote seed1/smote --published "
  rm -f reports
  make --silent figures report BIN=fake RUN=t >/dev/null
  expect_equal "$(ran)" ""
  expect_line "$(command_of real/figures)" "--leave-out seed0/smote seed1/smote "
  expect_line "$(<reports)" "--leave-out $(echo {made,real}/seed{0,1}/smote)"
  rm -r results/t/real/seed1/piae-dt
  grid METHODS="none piae-dt" SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
}

test_goals_go_together() {
  describe
  make --silent -j2 all figures report results/t/real/seed0/A.h5 BIN=fake RUN=t DATASETS=real METHODS=smote \
    RATIOS=10to1 SEEDS=0 >output
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 1 train"
  ! grep 'Nothing to be done' output || fail "make says that something was not done"
}

run_tests "$@"
