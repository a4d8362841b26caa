#!/bin/bash
# Runs from before 0.1.0, in which the paper's classifier did not have a folder: make refuses them, and one command
# moves their files.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/small_grid.sh"

cells() { make --silent "$@" BIN=fake RUN=t DATASETS=real METHODS="none piae-dt" RATIOS="100to1 10to1" SEEDS=0; }
new_layout() { pipeline/new_layout.sh "$@" 2>&1; }
state() { find results/t -type f ! -name .journal -printf '%P %T@\n' | sort; }

# Makes a present run and moves its files to the old layout.
old_run() {
  describe
  printf '[sweep]\npoints = ["batch=1"]\n[readings]\nreadings = ["batches=class"]\n' >>pipeline/protocol.toml
  cells all trust >/dev/null
  local trial folder
  for trial in sweep/batch-1 sweep@smote/neighbours-3 readings/base; do
    mkdir -p "results/t/real/seed0/$trial"
    cp -r results/t/real/seed0/piae-dt/10to1 "results/t/real/seed0/$trial"
  done
  touch results/t/real/seed0/piae-dt/10to1/wdcnn/diagnosis.h5.checkpoint
  state >new
  find results/t -type d -name wdcnn >folders
  while read -r folder; do mv "$folder"/* "${folder%/*}" && rmdir "$folder"; done <folders
  rm calls results/t/.journal # did not exist before 0.1.0
}

test_make_refuses_an_old_run_in_one_line() {
  old_run
  state >before
  local goal line='results/t/real: its cells are laid out as before 0.1.0 \(seed0/[^ ]*to1/diagnosis.h5\); pipeline/new_layout.sh results/t moves them'
  for goal in cells all figures report sweep trust status; do
    expect_exit 2 cells $goal
    expect_line "$(cells $goal 2>&1 || true)" "$line"
  done
  [[ ! -e calls ]] || fail "ran: $(<calls)"
  expect_equal "$(state)" "$(<before)"
  # Trials without other cells are found, too.
  rm -r results/t/real/seed0/{none,piae-dt,sweep,sweep@smote}
  expect_line "$(cells cells 2>&1 || true)" '\(seed0/readings/base/10to1/diagnosis.h5\)'
}

test_one_command_moves_the_files_without_recomputing_a_cell() {
  old_run
  expect_line "$(new_layout results/t)" '^results/t: [0-9]+ files moved$'
  expect_equal "$(state)" "$(<new)"
  expect_equal "$(new_layout results/t/)" 'results/t/: 0 files moved'
  cells all trust >/dev/null
  expect_equal "$(ran_with_features)" "1 tabulate, 1 trust" # nothing records how their tables were made
}

test_refuses_other_folders_and_does_not_replace_files() {
  old_run
  state >before
  expect_exit 65 pipeline/new_layout.sh results/t results/published
  expect_equal "$(new_layout results/t results/published)" \
    'new_layout.sh: results/published: is not a run, because it does not have a folder DATASET/seedK; name one such as results/paper'
  expect_exit 2 pipeline/new_layout.sh
  expect_equal "$(state)" "$(<before)"
  local cell=results/t/real/seed0/piae-dt/10to1
  mkdir $cell/wdcnn
  echo other >$cell/wdcnn/diagnosis.h5
  expect_exit 65 pipeline/new_layout.sh results/t
  expect_line "$(new_layout results/t)" "^new_layout.sh: $cell/diagnosis.h5: exists in $cell/wdcnn, too; remove one of the two$"
  expect_equal "$(<$cell/wdcnn/diagnosis.h5)" other
}

run_tests "$@"
