#!/bin/bash
# Data sets of which no fault window is known: which cells there are, and what is said of the others.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

# One with known faults and one without; a rule, and a method that needs no known fault, beside what there is.
describe() {
  rm -f pipeline/datasets/*
  printf 'name = "five"\n' >pipeline/datasets/five.toml
  printf 'name = "zero"\nlike = "five"\n[split]\nknown-per-class = 0\n' >pipeline/datasets/zero.toml
  printf '[sweep]\npoints = ["batch=1", "batch=5"]\n[train.piae-dt]\nbatch = 5\n[readings]\nreadings = ["batch=1"]\n' \
    >pipeline/protocol.toml
  rm fake/settings
  cat >fake/settings <<STAGE
#!/bin/bash
"$programs/settings" "\$@" || exit
[[ \$1 != --facts ]] || printf '%s\n' classifier:lines pair:none/lines pair-of-nothing:none/lines \
  method:inventor pair:inventor/wdcnn pair-of-nothing:inventor/wdcnn pair:inventor/nearest pair-of-nothing:inventor/nearest
STAGE
  chmod +x fake/settings
}

grid() { # goal, variables
  make --silent "$1" BIN=fake RUN=t DATASETS="five zero" METHODS="none smote inventor oracle" RATIOS="100to1 1to1" SEEDS=0 "${@:2}"
}
list_cells() { # variables
  make --silent --file=pipeline/grid.mk list-cells BIN=fake RUN=t results=results/t PROTOCOL=random DATA_DIR=data \
    DATASETS="five zero" METHODS="none smote inventor oracle" RATIOS="100to1 1to1" SEEDS=0 "$@"
}
cells_of() { # data set, variables
  list_cells DATASETS="$1" "${@:2}" 2>/dev/null | sed -n "s,^cell results/t/$1/seed0/,,p" | sort | xargs
}

test_without_rules_there_is_no_cell_of_none() {
  describe
  expect_equal "$(cells_of zero)" "inventor/1to1/wdcnn/diagnosis.h5 inventor/score.h5 oracle/1to1/wdcnn/diagnosis.h5"
  expect_equal "$(cells_of five METHODS="none smote")" \
    "none/100to1/nearest/diagnosis.h5 none/100to1/wdcnn/diagnosis.h5 smote/1to1/wdcnn/diagnosis.h5 smote/score.h5"
  expect_equal "$(cells_of zero CLASSIFIERS="wdcnn nearest")" \
    "inventor/1to1/nearest/diagnosis.h5 inventor/1to1/wdcnn/diagnosis.h5 inventor/score.h5 oracle/1to1/nearest/diagnosis.h5 oracle/1to1/wdcnn/diagnosis.h5"
}

test_rules_are_run_with_none_alone() {
  describe
  expect_equal "$(cells_of zero CLASSIFIERS="wdcnn lines" METHODS="none inventor")" \
    "inventor/1to1/wdcnn/diagnosis.h5 inventor/score.h5 none/100to1/lines/diagnosis.h5"
  expect_equal "$(cells_of five CLASSIFIERS="wdcnn lines" METHODS="none smote")" \
    "none/100to1/lines/diagnosis.h5 none/100to1/nearest/diagnosis.h5 none/100to1/wdcnn/diagnosis.h5 smote/1to1/wdcnn/diagnosis.h5 smote/score.h5"
  expect_equal "$(cells_of five CLASSIFIERS=lines)" \
    "none/100to1/lines/diagnosis.h5 none/100to1/nearest/diagnosis.h5"
}

test_what_is_left_out_is_said_once() {
  describe
  local said
  said=$(grid all 2>&1 >/dev/null)
  expect_equal "$said" "zero: no fault window is known, so these are left out: none, smote"
  said=$(list_cells CLASSIFIERS=lines METHODS="none inventor" 2>&1 >/dev/null)
  expect_equal "$(wc -l <<<"$said")" 2
  expect_line "$said" "^five: rules are run with none alone, so these are left out: inventor$"
  expect_line "$said" "^zero: rules are run with none alone, so these are left out: inventor$"
  expect_equal "$(list_cells DATASETS=five 2>&1 >/dev/null)" ""
}

test_steps_are_those_of_the_cells() {
  describe
  grid all DATASETS=zero CLASSIFIERS="wdcnn lines" 2>/dev/null >/dev/null
  expect_equal "$(sort calls | xargs -d '\n' | sed 's,zero/seed0/,,g')" "$(sort <<'STEPS' | xargs -d '\n'
ingest zero
split zero/seed0
train inventor
train oracle
generate inventor
generate oracle
score inventor
diagnose inventor/1to1/wdcnn
diagnose oracle/1to1/wdcnn
diagnose none/100to1/lines
features inventor/1to1/wdcnn
features oracle/1to1/wdcnn
tabulate zero
STEPS
)"
  expect_line "$(<results/t/zero/tables.md)" "--methods none smote inventor oracle .*--nothing-known zero "
  expect_line "$(<reports)" "--nothing-known zero$"
  expect_no_line "$(cat results/t/zero/seed0/inventor/model.h5)" "--real"
  rm calls
  grid all DATASETS=zero CLASSIFIERS="wdcnn lines" 2>/dev/null >/dev/null
  [[ ! -e calls ]] || fail "made again: $(<calls)"
}

test_nothing_left_is_an_error() {
  describe
  local said
  said=$(grid all METHODS="none smote" 2>&1) && fail "no error"
  expect_line "$said" "zero: nothing is left to be made; no fault window is known, so these are left out: none, smote, wdcnn; choose of METHODS=.*none oracle.* CLASSIFIERS=.*envelope-rule.*wdcnn"
  [[ ! -e calls ]] || fail "something was made"
  # Who looks at a run asks for nothing.
  expect_exit 0 grid all DATASETS=zero METHODS=oracle
  expect_exit 0 make --silent report BIN=fake RUN=t DATASETS=zero
}

test_what_is_about_known_windows_is_refused() {
  describe
  local goal said
  for goal in sweep readings; do
    said=$(grid "$goal" METHODS="piae-dt oracle" DATASETS=zero 2>&1) && fail "no error of $goal"
    expect_line "$said" "make $goal: zero: no fault window is known, and "
  done
  said=$(grid contrast DATASETS=zero --dry-run 2>/dev/null)
  expect_line "$said" "contrast --with .* --methods inventor oracle --ratios"
}

test_status_counts_the_cells_that_there_are() {
  describe
  grid cells DATASETS=zero 2>/dev/null >/dev/null
  expect_line "$(grid status DATASETS=zero 2>/dev/null)" "^all +3 +3 "
}

run_tests "$@"
