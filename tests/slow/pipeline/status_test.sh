#!/bin/bash
# `make status`: what is done, running, failed and missing, and how long the rest will take.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

describe() {
  rm -f pipeline/datasets/*
  printf 'name = "real"\n' >pipeline/datasets/real.toml
  printf 'name = "made"\n[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  printf '[train.smote]\nneighbours = 4\n' >pipeline/protocol.toml
}

with_grid() { # goal, variables
  make --silent "$1" BIN=fake RUN=t METHODS="none smote" RATIOS="100to1 10to1 1to1" SEEDS="0 1" "${@:2}"
}
status() { with_grid status DATASETS=real "$@"; }
# Their logs say that steps took no time, whatever they did on this machine: the time left is tested by itself.
cells() {
  local code=0
  with_grid cells DATASETS=real "$@" >/dev/null 2>&1 || code=$?
  find results -name '*.log' -exec sed -i 's/^step: exit 0 after .*/step: exit 0 after 0.0 s/' {} +
  return "$code"
}

# The words of a line of the table, with one space between.
counts() { # data set, method
  status "${@:3}" | awk -v d="$1" -v m="$2" '$1 == d && (d == "all" || $2 == m) { $1 = $1; print }'
}

# The log of a step as if it had taken this long.
took() { # folder, stage, seconds
  sed -i "s/^step: exit 0 after .*/step: exit 0 after $3 s/" "results/t/$1/$2.log"
}

test_before_anything_has_run() {
  describe
  local output
  output=$(status DATASETS="real made")
  expect_line "$output" '^data set +method +cells +done +running +failed +missing +time left$'
  expect_line "$output" '^real +none +4 +0 +0 +0 +4 +not known yet$'
  expect_line "$output" '^made +smote +6 +0 +0 +0 +6 +not known yet$'
  expect_line "$output" '^all +20 +0 +0 +0 +20 +not known yet$'
  [[ ! -e results/t && ! -e calls ]] || fail "status has made something"
}

test_when_all_is_done() {
  describe
  cells
  expect_equal "$(status | sed 's/  */ /g')" "$(printf '%s\n' \
    'data set method cells done running failed missing time left' \
    'real none 4 4 0 0 0 0 s' 'real smote 6 6 0 0 0 0 s' 'all 10 10 0 0 0 0 s')"
}

test_only_the_chosen_part_is_counted() {
  describe
  cells SEEDS=0
  expect_equal "$(counts all '')" 'all 10 5 0 0 5 0 s'
  expect_equal "$(counts all '' SEEDS=0)" 'all 5 5 0 0 0 0 s'
  expect_equal "$(counts all '' SEEDS=1 METHODS=smote RATIOS=1to1)" 'all 2 0 0 0 2 0 s'
  expect_equal "$(counts all '' PROTOCOL=blocked | cut -d' ' -f1-6)" 'all 10 0 0 0 10'
}

test_a_failed_step_is_named_with_its_reason_and_log() {
  describe
  echo "train real/seed1/smote/model.h5" >broken
  cells -k || true
  local output
  output=$(status)
  expect_equal "$(counts real smote)" 'real smote 6 3 0 3 0 0 s'
  expect_equal "$(counts real none)" 'real none 4 4 0 0 0 0 s'
  expect_equal "$(tail -n 2 <<<"$output")" \
    $'failed\n  real/seed1/smote: train: the reason (log: results/t/real/seed1/smote/train.log)'
  rm broken
  cells
  expect_equal "$(counts real smote)" 'real smote 6 6 0 0 0 0 s'
}

# Classifiers wait for the same windows, and not for one another.
test_a_failed_diagnosis_is_a_cell_of_its_classifier_alone() {
  describe
  echo "diagnose real/seed1/smote/1to1/wdcnn/diagnosis.h5" >broken
  cells -k CLASSIFIERS="wdcnn wdcnn-spectrum" || true
  # Per seed two scores and diagnoses at two ratios by two classifiers each.
  expect_equal "$(counts real smote CLASSIFIERS="wdcnn wdcnn-spectrum")" 'real smote 10 9 0 1 0 0 s'
  echo "diagnose real/seed1/smote/1to1/wdcnn-spectrum/diagnosis.h5" >broken
  rm -r results
  cells -k CLASSIFIERS="wdcnn wdcnn-spectrum" || true
  expect_equal "$(counts real smote CLASSIFIERS="wdcnn wdcnn-spectrum")" 'real smote 10 9 0 1 0 0 s'
  expect_equal "$(counts real smote)" 'real smote 6 6 0 0 0 0 s'
  expect_line "$(status CLASSIFIERS="wdcnn wdcnn-spectrum")" \
    '^  real/seed1/smote/1to1/wdcnn-spectrum: diagnose: the reason \(log: '
}

# A terminal would obey them.
test_control_characters_of_logs_are_not_printed() {
  describe
  echo "train real/seed1/smote/model.h5" >broken
  cells -k || true
  local log=results/t/real/seed1/smote/train.log output
  sed -i 's/^train: the reason$/train: \x1b]0;evil\x07 \x00\x1b[31mred\x7f\xff µ/' $log
  submitted all RUN=t DATASETS=real results=results/t
  printf 'job: life ended at 1, used 1 s, status 1: \e[2Jgone\n' >$jobs/cells.0.log
  printf 'spent: \e[2Jnothing\n' >$jobs/tables.log
  output=$(status)
  expect_line "$(LC_ALL=C tr '\377' y <<<"$output")" '^  real/seed1/smote: train: \?]0;evil\? \?\?\[31mred\?y µ \(log: '
  expect_line "$output" '^  cells.0: \?\[2Jgone \(log: '
  expect_line "$output" '^spent: \?\[2Jnothing$'
  # Nor those of what was submitted.
  printf 'a\e[31mll\n' >$jobs/choice
  expect_line "$(status 2>&1 || true)" "not 'a\?\[31mll'$"
}

test_a_failed_score_is_one_cell() {
  describe
  echo "score real/seed1/smote/score.h5" >broken
  cells -k || true
  expect_equal "$(counts real smote)" 'real smote 6 5 0 1 0 0 s'
}

test_a_crash_without_a_word_is_a_failure() {
  describe
  rm fake/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\nkill -SEGV $$\n' >fake/train
  chmod +x fake/train
  cells SEEDS=0 || true
  expect_line "$(status)" '^  real/seed0/smote: train: exit code 139 \(log'
}

# A train that runs until it is stopped.
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

test_running_is_what_a_living_process_is_at() {
  describe
  endless_train
  with_grid cells DATASETS=real SEEDS=0 >/dev/null 2>&1 &
  wait_for started
  until grep -q 40 results/t/real/seed0/smote/train.log; do sleep 0.05; done
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 3 0 3'
  expect_line "$(status)" '^  real/seed0/smote: train  ####....   40 % \(log: '
  # Stopped in order: a checkpoint, nothing failed.
  kill -TERM "$(<started)"
  expect_exit 2 wait $!
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 0 0 6'
}

test_killed_is_missing_but_its_orphan_runs() {
  describe
  endless_train
  mkdir -p results/t/real/seed0/smote
  BIN=fake SUBMIT='' pipeline/step.sh results/t/real/seed0/smote train >/dev/null 2>&1 &
  wait_for started
  kill -KILL $!
  { wait $! || true; } 2>/dev/null
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 3 0 3'
  kill -KILL "$(<started)"
  until flock --nonblock results/t/real/seed0/smote/train.log true; do sleep 0.05; done
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 0 0 6'
}

test_a_changed_setting_makes_cells_missing_and_status_changes_nothing() {
  describe
  cells
  rm calls
  sed -i 's/4/3/' pipeline/protocol.toml
  expect_equal "$(counts real smote | cut -d' ' -f1-7)" 'real smote 6 0 0 0 6'
  expect_equal "$(counts real none)" 'real none 4 4 0 0 0 0 s'
  expect_line "$(<results/t/.settings/train.smote.toml)" "neighbours = 4"
  sed -i 's/3/4/' pipeline/protocol.toml
  cells
  [[ ! -e calls ]] || fail "status has made steps run again: $(<calls)"
}

# Seed 0 is done: train 100 s, generate 10 s, score 1 s, diagnose 20 s at 10to1 and 40 s at 1to1.
# Of seed 1 all but one diagnosis of 40 s is there; seed 2 is new and needs a split of 5 s, and 171 s
# for smote.
test_the_time_left_is_that_of_steps_like_those_to_come() {
  describe
  cells
  local seed
  for seed in seed0 seed1; do
    took real/$seed split 5
    took real/$seed/none/100to1/wdcnn diagnose 7
    took real/$seed/none/100to1/nearest diagnose 1
    took real/$seed/smote train 100
    took real/$seed/smote generate 10
    took real/$seed/smote score 1
    took real/$seed/smote/10to1/wdcnn diagnose 20
    took real/$seed/smote/1to1/wdcnn diagnose 40
  done
  rm results/t/real/seed1/smote/1to1/wdcnn/diagnosis.h5
  expect_equal "$(counts real smote)" 'real smote 6 5 0 0 1 40 s'
  local output
  output=$(status SEEDS="0 1 2" | sed 's/  */ /g')
  expect_line "$output" '^real records, split 0 0 0 0 0 5 s$'
  expect_line "$output" '^real none 6 4 0 0 2 8 s$'
  expect_line "$output" '^real smote 9 5 0 0 4 4 min$' # 40 + 171 s
  expect_line "$output" '^all 15 9 0 0 6 4 min$'
  # The mean of seeds that differ.
  took real/seed0/smote train 7000
  output=$(status SEEDS="0 1 2" | sed 's/  */ /g')
  expect_line "$output" '^real smote 9 5 0 0 4 1 h 01 min$' # 3550 + 111 s
}

test_another_data_set_or_method_stands_in_where_nothing_is_known() {
  describe
  cells
  took real/seed0/none/100to1/wdcnn diagnose 10
  took real/seed1/none/100to1/wdcnn diagnose 30
  took real/seed0/none/100to1/nearest diagnose 3
  took real/seed1/none/100to1/nearest diagnose 3
  expect_equal "$(counts made none DATASETS=made)" 'made none 4 0 0 0 4 46 s'
  took real/seed0/smote/1to1/wdcnn diagnose 30
  took real/seed1/smote/1to1/wdcnn diagnose 30
  sed -i '/^step:/d' results/t/real/seed*/smote/train.log
  expect_line "$(status DATASETS=made)" '^made +smote .* 6 +1 min or more$'
}

test_wrong_words_are_refused() {
  describe
  expect_line "$(status METHODS=magic 2>&1 || true)" "unknown 'magic'"
  expect_exit 2 status METHODS=magic
}

# As if `make cluster` had submitted this run, and Slurm, which answers unless there is a file `no-slurm`, had
# nothing of it in its queue any more.
submitted() { # goal, variables
  jobs=results/t/.jobs/20260101T000000
  mkdir -p $jobs path
  printf '%s\n' "$@" >$jobs/choice
  : >$jobs/submitted
  printf '#!/bin/bash\n[[ ! -e no-slurm ]]\n' >path/squeue
  chmod +x path/squeue
  PATH=$PWD/path:$PATH
}

# What other questions ask for.
describe_others() {
  describe
  cat >pipeline/protocol.toml <<'TOML'
[train.piae-dt]
depth = 3
[sweep]
points = ["depth=1", "depth=3"]
[readings]
base = ["depth=2"]
readings = ["depth=4"]
TOML
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ntouch "${1%%.csv}.svg" "${1%%.csv}.pdf"\n' >pipeline/figures/draw.sh
}

test_a_failed_step_of_a_sweep_is_named() {
  describe_others
  local which=(BIN=fake RUN=t DATASETS=real SEEDS="0 1") output
  echo "train real/seed1/sweep/depth-1/model.h5" >broken
  make --silent -k sweep "${which[@]}" >/dev/null 2>&1 || true
  rm calls
  output=$(make --silent status sweep "${which[@]}" | sed 's/  */ /g')
  expect_line "$output" '^real piae-dt 4 4 0 0 0 0 s$'
  expect_line "$output" '^real sweep 4 2 0 2 0 0 s$'
  expect_line "$output" '^ real/seed1/sweep/depth-1: train: the reason \(log: results/t/real/seed1/sweep/depth-1/train.log\)$'
  # Of what was submitted to a cluster nobody need say again what it was.
  submitted sweep RUN=t DATASETS=real SEEDS="0 1" results=results/t
  expect_equal "$(make --silent status BIN=fake RUN=t | sed 's/  */ /g')" "$output"
  [[ ! -e calls ]] || fail "status has computed: $(<calls)"
  # The table itself.
  echo "sweep real/sweep.csv" >broken
  make --silent sweep "${which[@]}" >/dev/null 2>&1 || true
  output=$(make --silent status sweep "${which[@]}")
  expect_line "$output" '^all +8 +8 +0 +0 +0 +0 s'
  expect_equal "$(tail -n 2 <<<"$output")" $'failed\n  real: sweep: the reason (log: results/t/real/sweep.log)'
}

test_a_failed_step_of_the_parts_of_a_method_is_named() {
  describe_others
  printf '[sweep.smote]\npoints = ["neighbours=1"]\n' >>pipeline/protocol.toml
  local which=(BIN=fake RUN=t DATASETS=real SEEDS="0 1" METHODS="piae-dt smote") output
  echo "train real/seed1/sweep@smote/neighbours-1/model.h5" >broken
  make --silent -k sweep "${which[@]}" >/dev/null 2>&1 || true
  output=$(make --silent status sweep "${which[@]}" | sed 's/  */ /g')
  expect_line "$output" '^real smote 4 4 0 0 0 0 s$'
  expect_line "$output" '^real sweep 4 4 0 0 0 0 s$'
  expect_line "$output" '^real sweep@smote 4 2 0 2 0 0 s$'
  expect_line "$output" '^ real/seed1/sweep@smote/neighbours-1: train: the reason '
  # The table itself, whose log is not that of the other table.
  echo "sweep real/sweep@smote.csv" >broken
  make --silent sweep "${which[@]}" >/dev/null 2>&1 || true
  output=$(make --silent status sweep "${which[@]}")
  expect_line "$output" '^all +16 +16 +0 +0 +0 +0 s'
  expect_equal "$(tail -n 2 <<<"$output")" \
    $'failed\n  real: sweep: the reason (log: results/t/real/sweep@smote.log)'
}

test_what_is_given_goes_before_what_was_submitted() {
  describe
  submitted all RUN=t DATASETS="real made" METHODS=smote RATIOS=10to1 SEEDS="0 1 2" results=results/t
  expect_line "$(make --silent status BIN=fake RUN=t)" '^all +12 +0 '
  expect_line "$(make --silent status BIN=fake RUN=t SEEDS=0 DATASETS=real)" '^all +2 +0 '
  expect_line "$(make --silent status cells BIN=fake RUN=t SEEDS=0 DATASETS=real METHODS=smote)" '^all +7 +0 '
}

test_a_failed_reading_is_named() {
  describe_others
  local which=(readings BIN=fake RUN=t DATASETS=real SEEDS=100) output
  echo "score real/seed100/readings/depth-4/score.h5" >broken
  make --silent -k "${which[@]}" >/dev/null 2>&1 || true
  output=$(make --silent status "${which[@]}" | sed 's/  */ /g')
  expect_line "$output" '^all 6 5 0 1 0 0 s$'
  expect_line "$output" '^ real/seed100/readings/depth-4: score: the reason \(log: '
  submitted readings RUN=t DATASETS=real METHODS=piae-dt SEEDS=100 results=results/t
  expect_equal "$(make --silent status BIN=fake RUN=t | sed 's/  */ /g')" "$output"
  # The run that they have when nobody says otherwise.
  mv results/t results/readings
  expect_line "$(make --silent status readings BIN=fake)" '^  real/seed100/readings/depth-4: score: the reason \(log: '
}

test_a_contrast_is_of_both_protocols() {
  describe
  with_grid cells DATASETS=real >/dev/null 2>&1
  echo "diagnose real/seed1/smote/10to1/wdcnn/diagnosis.h5" >broken
  with_grid contrast DATASETS=real >/dev/null 2>&1 || true
  local output
  output=$(with_grid status DATASETS=real | sed 's/  */ /g')
  expect_line "$output" '^all 10 10 0 0 0 0 s$'
  submitted contrast RUN=t DATASETS=real results=results/t
  output=$(with_grid status DATASETS=real)
  expect_line "$output" '^real +smote +6 +6 +0 +0 +0 +0 s$'
  expect_line "$output" '^real, blocked +smote +6 +[0-9] +0 +1 '
  expect_line "$output" '^all +20 +[0-9]+ +0 +1 '
  expect_line "$output" \
    '^  results/t-blocked/real/seed1/smote/10to1/wdcnn: diagnose: the reason \(log: results/t-blocked/real/seed1/smote/10to1/wdcnn/'
  rm broken
  with_grid contrast DATASETS=real >/dev/null 2>&1
  output=$(with_grid status contrast DATASETS=real)
  expect_line "$output" '^all +20 +20 +0 +0 +0 +0 s$'
  expect_no_line "$output" failed$
}

test_an_identification_is_of_models() {
  describe
  printf '[train.piae-dt]\nepochs = 2\n' >pipeline/protocol.toml
  local which=(identify BIN=fake RUN=t DATASETS=made METHODS=piae-dt SEEDS="0 1") output
  echo "train made/seed1/piae-dt/model.h5" >broken
  make --silent -k "${which[@]}" >/dev/null 2>&1 || true
  output=$(make --silent status "${which[@]}")
  expect_line "$output" '^data set +method +models +done '
  expect_line "$output" '^made +piae-dt +2 +1 +0 +1 +0 +0 s$'
  expect_line "$output" '^  made/seed1/piae-dt: train: the reason \(log: '
}

# They are no cell: the diagnosis beside them is.
test_features_that_failed_are_named() {
  describe
  echo "diagnose real/seed0/smote/1to1/wdcnn/features.h5" >broken
  with_grid all DATASETS=real -k >/dev/null 2>&1 || true
  local output
  output=$(status)
  expect_line "$output" '^all +10 +10 +0 +0 +0 +0 s$'
  expect_equal "$(tail -n 2 <<<"$output")" \
    $'failed\n  real/seed0/smote/1to1/wdcnn: diagnose: the reason (log: results/t/real/seed0/smote/1to1/wdcnn/features.log)'
  # They were not asked for by make cells.
  expect_no_line "$(status cells)" failed$
}

test_tables_that_failed_are_named() {
  describe
  echo "tabulate real/accuracy.csv" >broken
  with_grid all DATASETS=real -k >/dev/null 2>&1 || true
  local output
  output=$(status)
  expect_line "$output" '^all +10 +10 +0 +0 +0 +0 s$'
  expect_equal "$(tail -n 2 <<<"$output")" $'failed\n  real: tabulate: the reason (log: results/t/real/tabulate.log)'
  # As the job of the tables says, where it was killed.
  sed -i '/^step: exit/d; /^tabulate: /d' results/t/real/tabulate.log
  submitted all RUN=t DATASETS=real results=results/t
  echo "job: life begun at 1 on n1, 4 cores" >$jobs/tables.log
  expect_line "$(status)" '^  real: tabulate: its job ended: killed \(log: '
}

test_what_cannot_be_counted_is_refused() {
  describe
  expect_line "$(status sweep contrast 2>&1 || true)" 'one of .* at a time'
  expect_line "$(status figures 2>&1 || true)" 'one of .* at a time'
}

test_a_step_that_runs_and_has_said_nothing_yet_is_shown_by_its_name() {
  describe
  endless_train
  sed -i '/####/d' fake/train
  with_grid cells DATASETS=real SEEDS=0 >/dev/null 2>&1 &
  wait_for started
  local output
  output=$(status)
  kill -TERM "$(<started)"
  expect_exit 2 wait $!
  expect_line "$output" '^  real/seed0/smote: train \(log: results/t/real/seed0/smote/train.log\)$'
  expect_no_line "$output" ended
}

# Where locks are not shared between nodes, a step that runs is like one that was killed.
test_a_job_without_an_end_was_killed_only_when_slurm_says_that_it_is_gone() {
  describe
  local folder=results/t/real/seed0/smote output
  mkdir -p $folder
  printf '%s\n' train 'step: begun at 1.0' >$folder/train.log
  submitted all RUN=t DATASETS=real results=results/t
  echo $folder/model.h5 >$jobs/cells.0
  echo "job: life begun at 1 on n1, 4 cores" >$jobs/cells.0.log
  output=$(status)
  expect_line "$output" '^  real/seed0/smote: train: its job ended: killed \(log: '
  expect_line "$output" '^  cells.0: killed \(log: '
  touch no-slurm
  output=$(status)
  expect_no_line "$output" 'killed|failed$'
  expect_line "$output" 'squeue does not answer'
  # What a log says itself is known all the same.
  echo "slurmstepd: error: Detected 1 oom_kill event in StepId=5.0." >>$jobs/cells.0.log
  expect_line "$(status)" '^  cells.0: out of memory \(log: '
}

# A step may outlive its stage, and can then only guess. Its job knows.
test_a_step_of_a_job_that_ran_out_of_memory_says_so_whatever_it_guessed() {
  describe
  local folder=results/t/real/seed0/smote guess='train: killed, perhaps for want of memory'
  mkdir -p $folder
  printf '%s\n' train 'step: begun at 1.0' "$guess" 'step: exit 137 after 1.0 s' >$folder/train.log
  submitted all RUN=t DATASETS=real results=results/t
  echo $folder/model.h5 >$jobs/cells.0
  printf '%s\n' 'job: life begun at 1 on n1, 4 cores' 'job: life ended at 2, status 1: some steps failed' >$jobs/cells.0.log
  expect_line "$(status)" "^  real/seed0/smote: $guess \\(log: "
  echo 'slurmstepd: error: Detected 1 oom_kill event in StepId=5.0.' >>$jobs/cells.0.log
  expect_line "$(status)" '^  real/seed0/smote: train: its job ended: out of memory \(log: '
}

run_tests "$@"
