#!/bin/bash
# Arguments of `make check` and `make reference`. Tests of the comparison itself: reference_test.sh and
# tests/regression/.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# Makes a stage that only prints its arguments, and fails on request.
check_stage() {
  # shellcheck disable=SC2016
  printf '#!/bin/bash\necho "$*" | tee -a calls\n[[ ! -e moved ]]\n' >fake/check
  chmod +x fake/check
}

called() { make --silent "$@" BIN=fake; }

test_compares_everything_unless_a_part_is_given() {
  check_stage
  expect_equal "$(called check RUN=try)" \
    "--run results/try --reference results/reference --tolerance auto"
  expect_equal "$(called check RUN=try SEEDS="0 1" DATASETS="cwru hit-sm" METHODS=none RATIOS=100to1 TOLERANCE=exact)" \
    "--run results/try --reference results/reference --datasets cwru hit-sm --methods none --ratios 100to1 --seeds 0 1 --tolerance exact"
}

test_the_run_is_a_name_or_a_folder() {
  check_stage
  local run
  for run in try results/try results/try/; do
    expect_line "$(called check RUN=$run)" '^--run results/try --'
  done
  expect_line "$(called check)" '^--run results/paper --'
  expect_line "$(called check RUN=results/try PROTOCOL=blocked)" '^--run results/try-blocked --'
}

test_reference_stores() {
  check_stage
  expect_equal "$(called reference RUN=results/try DATASETS=cwru)" \
    "--run results/try --reference results/reference --datasets cwru --store"
}

test_fails_for_a_difference() {
  check_stage
  expect_exit 0 called check
  touch moved
  expect_exit 2 called check
}

test_does_not_change_the_run() {
  check_stage
  mkdir -p results/t/cwru
  echo numbers >results/t/cwru/tables.md
  local before
  before=$(find results/t -type f -exec sha256sum {} + && find results/t -printf '%p %T@\n')
  called check RUN=t >/dev/null
  called reference RUN=t >/dev/null
  expect_equal "$(wc -l <calls)" 2
  expect_equal "$(find results/t -type f -exec sha256sum {} + && find results/t -printf '%p %T@\n')" "$before"
}

test_refuses_a_misspelled_protocol_before_comparing_or_storing() {
  check_stage
  local goal
  for goal in check reference; do
    expect_line "$(make --silent $goal BIN=fake RUN=try PROTOCOL=Blocked 2>&1 || true)" \
      "PROTOCOL: must be random or blocked, not 'Blocked'"
  done
  [[ ! -e calls ]] || fail "ran: $(<calls)"
}

run_tests "$@"
