#!/bin/bash
# Requests that make refuses before anything runs, and goals that only show and write nothing.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/small_grid.sh"

test_unknown_names_are_refused() {
  describe
  expect_line "$(grid DATASETS=nowhere 2>&1 || true)" "DATASETS: unknown 'nowhere'; choose from: made real"
  expect_line "$(grid RATIOS=3to1 2>&1 || true)" "RATIOS: unknown '3to1'"
  expect_line "$(grid METHODS=none RATIOS=1to1 2>&1 || true)" "no cells"
  expect_line "$(grid METHODS=magic 2>&1 || true)" "METHODS: unknown 'magic'; choose from: none dynamics smote "
  expect_line "$(grid CLASSIFIERS=svm 2>&1 || true)" "CLASSIFIERS: unknown 'svm'; choose from: wdcnn wdcnn-spectrum .* nearest"
  expect_line "$(grid CLASSIFIERS='nearest nearest' 2>&1 || true)" "CLASSIFIERS: 'nearest nearest' names the same item twice; remove one"
  expect_line "$(grid SEEDS='0 x' 2>&1 || true)" "SEEDS: must be whole numbers"
  expect_line "$(grid SEEDS='1 1' 2>&1 || true)" "names the same item twice"
  expect_line "$(grid SEEDS= 2>&1 || true)" "SEEDS: is empty"
  expect_line "$(grid RUN=../t 2>&1 || true)" "not a path"
  for sign in ':' '=' '%' ','; do
    expect_line "$(grid RUN="a${sign}b" 2>&1 || true)" "RUN: contains a $sign, which is not allowed"
  done
  expect_line "$(grid METHODS='smote smote' 2>&1 || true)" "METHODS: 'smote smote' names the same item twice; remove one"
  expect_line "$(grid RUN=reference 2>&1 || true)" "RUN: 'reference' cannot be the name of a run; choose another one, such as try"
  expect_line "$(grid PROTOCOL='random blocked' 2>&1 || true)" "PROTOCOL: must be random or blocked, not 'random blocked'"
  expect_exit 2 grid PROTOCOL=other
  expect_equal "$(ls)" "$(printf '%s\n' Makefile fake jobs pipeline results)"
}

# Otherwise a stage would run with its program's defaults.
test_an_unread_table_of_the_protocol_is_refused() {
  describe
  echo '[diagnoze]' >>pipeline/protocol.toml
  expect_line "$(grid 2>&1 || true)" "^plan: pipeline/protocol.toml, line 18: nothing reads the table \[diagnoze\]"
  sed -i 's/^\[diagnoze\]/[diagnose/' pipeline/protocol.toml
  expect_line "$(grid 2>&1 || true)" "^plan: pipeline/protocol.toml, line 18: not valid TOML"
  [[ ! -e calls ]] || fail "ran: $(<calls)"
}

test_unknown_variables_are_refused_with_the_right_name() {
  describe
  local pair
  for pair in SEED:SEEDS seeds:SEEDS METHOD:METHODS DATASET:DATASETS Ratio:RATIOS PROTOCOLS:PROTOCOL; do
    expect_line "$(make cells BIN=fake RUN=t "${pair%:*}=x" 2>&1 || true)" \
      "there is no variable ${pair%:*}; did you mean ${pair#*:}\?"
  done
  expect_line "$(make cells BIN=fake RUN=t THREADS=2 2>&1 || true)" "there is no variable THREADS; .make help. lists"
  expect_exit 2 make cells BIN=fake RUN=t SEED=0
  expect_exit 2 make help SEED=0
  [[ ! -e results/t ]] || fail "something ran"
}

# Files needed at the very end of a run must be reported missing before its first step.
test_missing_published_tables_are_reported_at_the_start() {
  describe
  rm -r results
  expect_exit 2 grid
  expect_line "$(grid 2>&1 || true)" 'results/published does not hold a table, .*git checkout results/published'
  expect_equal "$(ran)" ""
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=none RATIOS=100to1 SEEDS=0 >/dev/null # does not need them
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split"
}

test_missing_programs_are_reported_in_one_line() {
  describe
  local goal
  for goal in cells check status data demo; do
    expect_equal "$(make --silent $goal BIN=/nowhere 2>&1 | sed 's/^Makefile:[0-9]*: //')" \
      "*** BIN: there are no programs in '/nowhere'; \`make build\` builds them into build/bin.  Stop."
  done
  rm -r fake
  expect_line "$(make -n cells 2>&1 || true)" "build the programs first: .make build."
  expect_exit 0 make -n cells
}

# Older programs do not know later changes of the sources and of pipeline/.
test_a_dry_run_with_old_programs_asks_to_build_them() {
  describe
  mkdir -p build/bin src
  printf '#!/bin/bash\necho "plan: nothing reads the table [train.new]" >&2\nexit 65\n' >build/bin/plan
  chmod +x build/bin/plan
  touch -d '1 hour ago' build/bin/plan
  touch src/new.cpp
  expect_line "$(make -n cells 2>&1)" "build the programs first: .make build."
  touch build/bin/plan
  touch -d '1 hour ago' src/new.cpp src
  expect_line "$(make -n cells 2>&1 || true)" "nothing reads the table .train.new."
}

test_dry_runs_and_read_only_goals_write_nothing() {
  describe
  grid -n >/dev/null
  grid -n cells results/t/real/records.h5 >/dev/null
  expect_exit 1 grid -q
  [[ ! -e results/t ]] || fail "there is $(find results/t)"
}

test_libtorch_is_on_or_off() {
  describe
  expect_line "$(grid LIBTORCH=no 2>&1 || true)" "LIBTORCH: must be on or off, not 'no'"
}

run_tests "$@"
