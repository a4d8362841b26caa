#!/bin/bash
# Makes that start together, as array jobs on a cluster do, must not harm each other or rerun each other's steps. Many
# rounds: ROUNDS=200 tests/slow/pipeline/at_once_test.sh
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

cells() { make --silent cells BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" "$@"; }

four_at_once() { # round
  local seed makes=()
  for seed in 0 1 2 3; do
    cells "SEEDS=$seed" >"messages-$seed" 2>&1 &
    makes+=($!)
  done
  for seed in 0 1 2 3; do
    wait "${makes[seed]}" || fail "round $1, seed $seed: $(<"messages-$seed")"
  done
}

ran() { sort calls | uniq -c | sort -k2; }

test_four_makes_do_what_one_does() {
  echo 'name = "real"' >pipeline/datasets/real.toml
  cells SEEDS="0 1 2 3" -j4 >/dev/null
  mv results one && rm -r one/published
  local of_one round
  of_one=$(ran)
  for ((round = 1; round <= ${ROUNDS:-5}; ++round)); do
    rm -rf results calls
    four_at_once $round
    diff -r --exclude='*.log' --exclude=.journal results one >difference || fail "round $round: $(<difference)"
    expect_equal "$(ran)" "$of_one"
    # A later make must not find steps due because of an earlier one.
    expect_exit 0 cells SEEDS="0 1 2 3" -q
  done
}

# After a change of a setting, all four notice it and one of them writes it.
test_four_makes_after_a_change_do_what_one_does() {
  echo 'name = "real"' >pipeline/datasets/real.toml
  cells SEEDS="0 1 2 3" -j4 >/dev/null
  local round
  for ((round = 1; round <= ${ROUNDS:-5}; ++round)); do
    sed -i "s/^window = .*/window = $((1000 + round))/; s/^neighbours = .*/neighbours = $round/" pipeline/protocol.toml
    rm calls
    four_at_once $round
    expect_equal "$(awk '{ print $1 }' calls | sort | uniq -c | xargs)" "12 diagnose 4 generate 4 score 4 split 4 train"
    expect_equal "$(find results/t/.settings -type f | wc -l)" 6
  done
}

# A large array. The inputs of tables differ from make to make, and do not affect cells.
test_a_hundred_makes_all_succeed() {
  echo 'name = "real"' >pipeline/datasets/real.toml
  local seed makes=()
  for ((seed = 0; seed < 100; ++seed)); do
    cells "SEEDS=$seed" >"messages-$seed" 2>&1 &
    makes+=($!)
  done
  for seed in "${!makes[@]}"; do
    wait "${makes[seed]}" || fail "seed $seed: $(<"messages-$seed")"
  done
  expect_equal "$(ls results/t/.settings)" \
    "$(printf '%s\n' datasets diagnose.toml generate.toml score.toml split.toml train.smote.toml)"
}

# Tables of existing cells, while other cells have only started.
test_tables_are_made_while_cells_are() {
  echo 'name = "real"' >pipeline/datasets/real.toml
  local seed makes=()
  for ((seed = 0; seed < 12; ++seed)); do
    make --silent tables BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" "SEEDS=$seed" \
      >"messages-$seed" 2>&1 &
    makes+=($!)
  done
  for seed in "${!makes[@]}"; do
    wait "${makes[seed]}" || fail "seed $seed: $(<"messages-$seed")"
  done
}

# Else make would wait for the make that the script started, and that one for a job slot which the first has taken back.
test_killing_the_script_ends_its_make() {
  echo 'name = "real"' >pipeline/datasets/real.toml
  printf '#!/bin/bash\ntrap "exit 75" TERM\necho $$ >>started\nwhile :; do sleep 0.1; done\n' >endless
  chmod +x endless
  rm fake/simulate fake/ingest
  ln -s ../endless fake/simulate
  ln -s ../endless fake/ingest
  cells SEEDS=0 -j2 >messages 2>&1 &
  local make=$! tries=0
  wait_for started
  pkill -KILL --parent "$(pgrep --parent "$make")"
  while kill -0 "$make" 2>/dev/null; do
    ((++tries < 400)) || fail "make still waits"
    sleep 0.05
  done
  expect_exit 2 wait "$make"
  tries=0
  while ps -p "$(paste -sd, started)" >ended; do
    ((++tries < 400)) || fail "a stage still runs: $(<ended)"
    sleep 0.05
  done
}

run_tests "$@"
