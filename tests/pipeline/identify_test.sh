#!/bin/bash
# (k, c) of the twin against the truth.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

identify() { make --silent identify BIN=fake RUN=t SEEDS="0 1" "$@"; }

test_trains_and_compares_on_the_simulated_data_set() {
  identify METHODS="smote piae-dt" >/dev/null
  expect_equal "$(grep -c '^train' calls)" 2
  expect_equal "$(grep -c '^generate' calls || true)" 0
  expect_equal "$(<results/t/simulated/identifiability.md)" \
    "identify --config results/t/.settings/identify.simulated.toml --run results/t --dataset simulated --methods piae-dt --seeds 0 1"
  identify METHODS="smote piae-dt" >/dev/null
  expect_equal "$(grep -c '^identify' calls)" 1
}

test_is_of_all_models_that_the_run_holds() {
  printf '[train.piae-dt-phase]\nepochs = 2\n' >pipeline/protocol.toml
  identify METHODS="piae-dt piae-dt-phase" >/dev/null
  rm calls
  identify METHODS=piae-dt SEEDS=1 >/dev/null
  [[ ! -e calls ]] || fail "ran: $(<calls)"
  rm results/t/simulated/seed0/piae-dt-phase/model.h5
  identify METHODS=piae-dt >/dev/null
  expect_equal "$(<calls)" "identify simulated"
  sed -i 's/epochs = 2/epochs = 3/' pipeline/protocol.toml
  identify METHODS=piae-dt >/dev/null
  expect_line "$(<results/t/simulated/identifiability.md)" "--dataset simulated --leave-out seed1/piae-dt-phase --methods piae-dt --seeds 0 1"
}

test_says_what_it_needs() {
  expect_line "$(identify DATASETS=cwru METHODS=piae-dt 2>&1 || true)" 'DATASETS must have one that is simulated'
  expect_line "$(identify METHODS=smote 2>&1 || true)" 'METHODS must have one of piae-dt'
}

run_tests "$@"
