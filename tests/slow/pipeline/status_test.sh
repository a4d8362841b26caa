#!/bin/bash
# `make status` on a run by make. tests/plan/status_test.cpp tests its counts and messages in process.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  printf 'name = "real"\n' >pipeline/datasets/real.toml
  printf 'name = "made"\n[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  printf '[train.smote]\nneighbours = 4\n' >pipeline/protocol.toml
}

with_grid() { # goal, variables
  make --silent "$1" BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1 1to1" SEEDS="0 1" "${@:2}"
}
status() { with_grid status "$@" | tr -s ' '; }
# Sets all durations in the logs to zero, regardless of this machine: the time left has a test of its own.
cells() {
  local code=0
  with_grid cells "$@" >/dev/null 2>&1 || code=$?
  find results -name '*.log' -exec sed -i 's/^step: exit 0 after .*/step: exit 0 after 0.0 s/' {} +
  return "$code"
}
# Prints the words of a line of the table.
counts() { # data set, method, variables
  status "${@:3}" | awk -v d="$1" -v m="$2" '$1 == d && (d == "all" || $2 == m)'
}

test_counts_nothing_a_part_and_all() {
  describe
  expect_equal "$(counts all '')" 'all 10 0 0 0 10 not known yet'
  [[ ! -e results/t && ! -e calls ]] || fail "status has made something"
  cells SEEDS=0
  expect_equal "$(counts all '')" 'all 10 5 0 0 5 0 s'
  expect_equal "$(counts all '' SEEDS=1 METHODS=smote RATIOS=1to1)" 'all 2 0 0 0 2 0 s'
  cells
  rm calls
  expect_equal "$(status)" "$(printf '%s\n' \
    'data set method cells done running failed missing time left' \
    'real none 4 4 0 0 0 0 s' 'real smote 6 6 0 0 0 0 s' 'all 10 10 0 0 0 0 s')"
  expect_equal "$(counts all '' PROTOCOL=blocked | cut -d' ' -f1-6)" 'all 10 0 0 0 10'
  sed -i 's/4/3/' pipeline/protocol.toml
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 0 0 6'
  expect_line "$(<results/t/.settings/train.smote.toml)" "neighbours = 4"
  [[ ! -e calls ]] || fail "status has computed: $(<calls)"
  expect_line "$(status METHODS=magic 2>&1 || true)" "unknown 'magic'"
  expect_exit 2 with_grid status METHODS=magic
}

test_a_failed_step_is_named_with_its_reason_and_log() {
  describe
  echo "train real/seed1/smote/model.h5" >broken
  cells -k || true
  expect_equal "$(counts real smote)" 'real smote 6 3 0 3 0 0 s'
  expect_equal "$(status | tail -n 2)" \
    $'failed\n real/seed1/smote: train: the reason (log: results/t/real/seed1/smote/train.log)'
  rm broken fake/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\nkill -SEGV $$\n' >fake/train
  chmod +x fake/train
  cells || true
  expect_line "$(status)" '^ real/seed1/smote: train: exit code 139 \(log'
}

test_failed_tables_are_named() {
  describe
  echo "tabulate real/accuracy.csv" >broken
  with_grid all -k >/dev/null 2>&1 || true
  expect_equal "$(status | tail -n 2)" $'failed\n real: tabulate: the reason (log: results/t/real/tabulate.log)'
}

# A terminal would obey control characters.
test_control_characters_of_logs_are_not_printed() {
  describe
  echo "train real/seed1/smote/model.h5" >broken
  cells -k || true
  sed -i 's/^train: the reason$/train: \x1b]0;evil\x07 \x00\x1b[31mred\x7f\xff µ/' results/t/real/seed1/smote/train.log
  submitted all RUN=t DATASETS=real
  printf 'job: life ended at 1, used 1 s, status 1: \e[2Jgone\n' >$jobs/cells.0.log
  printf 'spent: \e[2Jnothing\n' >$jobs/tables.log
  local output
  output=$(with_grid status)
  expect_line "$output" '^  real/seed1/smote: train: \?]0;evil\? \?\?\[31mred\?\? µ \(log: '
  expect_line "$output" '^  cells.0: \?\[2Jgone \(log: '
  expect_line "$output" '^spent: \?\[2Jnothing$'
}

# Makes a train that runs until it is stopped.
endless_train() {
  rm fake/train
  cat >fake/train <<'STAGE'
#!/bin/bash
trap 'exit 75' TERM
echo "train  ####....   40 %" >&2
echo $$ >started
while :; do sleep 0.05; done
STAGE
  chmod +x fake/train
}

test_only_steps_of_living_processes_are_running() {
  describe
  endless_train
  with_grid cells SEEDS=0 >/dev/null 2>&1 &
  wait_for started
  until grep -q 40 results/t/real/seed0/smote/train.log; do sleep 0.05; done
  expect_equal "$(counts real smote SEEDS=0 | cut -d' ' -f1-7)" 'real smote 3 0 3 0 0'
  expect_line "$(status)" '^ real/seed0/smote: train ####.... 40 % \(log: '
  # A regular stop leaves a checkpoint, and nothing fails.
  kill -TERM "$(<started)"
  expect_exit 2 wait $!
  expect_equal "$(counts real smote SEEDS=0 | cut -d' ' -f1-7)" 'real smote 3 0 0 0 3'
}

test_a_killed_step_is_missing_unless_its_stage_still_runs() {
  describe
  endless_train
  mkdir -p results/t/real/seed0/smote
  BIN=fake SUBMIT='' pipeline/step.sh results/t/real/seed0/smote train >/dev/null 2>&1 &
  wait_for started
  kill -KILL $!
  { wait $! || true; } 2>/dev/null
  expect_equal "$(counts real smote SEEDS=0 | cut -d' ' -f1-7)" 'real smote 3 0 3 0 0'
  kill -KILL "$(<started)"
  until flock --nonblock results/t/real/seed0/smote/train.log true; do sleep 0.05; done
  expect_equal "$(counts real smote SEEDS=0 | cut -d' ' -f1-7)" 'real smote 3 0 0 0 3'
}

# Pretends that `make cluster` has submitted this run, and that Slurm, which answers unless a file `no-slurm` exists,
# does not have it in its queue any more.
submitted() { # goal, variables
  jobs=results/t/.jobs/20260101T000000
  mkdir -p $jobs path
  printf '%s\n' "$@" >$jobs/choice
  : >$jobs/submitted
  printf '#!/bin/bash\n[[ ! -e no-slurm ]]\n' >path/squeue
  chmod +x path/squeue
  PATH=$PWD/path:$PATH
}

test_given_variables_override_submitted_ones() {
  describe
  submitted all RUN=t DATASETS="real made" METHODS=smote RATIOS=10to1 SEEDS="0 1 2"
  expect_line "$(make --silent status BIN=fake RUN=t | tr -s ' ')" '^all 12 0 '
  expect_line "$(make --silent status BIN=fake RUN=t SEEDS=0 DATASETS=real | tr -s ' ')" '^all 2 0 '
  expect_line "$(make --silent status cells BIN=fake RUN=t SEEDS=0 DATASETS=real METHODS=smote | tr -s ' ')" '^all 7 0 '
}

# Without shared locks between nodes, a running step looks like a killed one.
test_a_job_without_an_end_was_killed_only_if_slurm_does_not_list_it() {
  describe
  local folder=results/t/real/seed0/smote output
  mkdir -p $folder
  printf '%s\n' train 'step: started at 1.0' >$folder/train.log
  submitted all RUN=t DATASETS=real
  echo $folder/model.h5 >$jobs/cells.0
  echo "job: life started at 1 on n1, 4 cores" >$jobs/cells.0.log
  output=$(status)
  expect_line "$output" '^ real/seed0/smote: train: its job ended: killed \(log: '
  expect_line "$output" '^ cells.0: killed \(log: '
  touch no-slurm
  output=$(status)
  expect_no_line "$output" 'killed|failed$'
  expect_line "$output" 'squeue does not answer'
  # Facts in the log are still known; a step may have outlived its stage and then can only guess.
  echo 'step: exit 137 after 1.0 s' >>$folder/train.log
  echo "slurmstepd: error: Detected 1 oom_kill event in StepId=5.0." >>$jobs/cells.0.log
  output=$(status)
  expect_line "$output" '^ real/seed0/smote: train: its job ended: out of memory \(log: '
  expect_line "$output" '^ cells.0: out of memory \(log: '
}

test_shows_every_goal() {
  describe
  printf '[train.piae-dt]\ndepth = 3\n[sweep]\npoints = ["depth=1", "depth=3"]\n' >>pipeline/protocol.toml
  local which=(BIN=fake RUN=t DATASETS=real SEEDS="0 1") output
  echo "train real/seed1/sweep/depth-1/model.h5" >broken
  make --silent -k sweep "${which[@]}" >/dev/null 2>&1 || true
  rm calls
  output=$(make --silent status sweep "${which[@]}" | tr -s ' ')
  expect_line "$output" '^real piae-dt 4 4 0 0 0 [0-9]+ s$'
  expect_line "$output" '^real sweep 4 2 0 2 0 '
  expect_line "$output" '^ real/seed1/sweep/depth-1: train: the reason '
  # Arguments of a submission need not be repeated.
  submitted sweep RUN=t DATASETS=real SEEDS="0 1"
  expect_equal "$(make --silent status BIN=fake RUN=t | tr -s ' ')" "$output"
  echo "train made/seed1/piae-dt/model.h5" >broken
  make --silent -k identify "${which[@]}" DATASETS=made METHODS=piae-dt >/dev/null 2>&1 || true
  output=$(make --silent status identify "${which[@]}" DATASETS=made METHODS=piae-dt | tr -s ' ')
  expect_line "$output" '^data set method models done '
  expect_line "$output" '^made piae-dt 2 1 0 1 0 '
  make --silent contrast "${which[@]}" METHODS=none RATIOS=100to1 >/dev/null 2>&1
  expect_line "$(make --silent status contrast "${which[@]}" METHODS=none RATIOS=100to1 | tr -s ' ')" \
    '^real, blocked none 2 2 0 0 0 '
}

run_tests "$@"
