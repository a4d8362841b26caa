#!/bin/bash
# One step of the grid: its line, its log, its exit code, and signals.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/small_grid.sh"

export BIN=fake SUBMIT=

# Makes a stage called `own` from the script on standard input.
own_stage() {
  { echo '#!/bin/bash' && cat; } >fake/own
  chmod +x fake/own
}

step() { pipeline/step.sh results/t/real/seed0 own "$@"; }

test_says_in_one_line_what_was_done() {
  own_stage <<<'echo many words; echo "made: 3 windows: results/t/real/seed0/A.h5"'
  expect_line "$(step)" '^real/seed0 +own +[0-9]+\.[0-9] s  3 windows$'
  expect_equal "$(step | wc -l)" 1
}

# Standard error reaches the log another way and may come last.
test_its_line_is_the_result_not_a_warning_or_progress() {
  own_stage <<<'echo "made 3 windows"; sleep 0.2; echo "own  ####   99 %" >&2; echo "own: one of them is silent" >&2'
  expect_line "$(step 2>/dev/null)" '^real/seed0 +own +[0-9]+\.[0-9] s  made 3 windows$'
}

test_its_line_gives_the_result_in_100_columns() {
  own_stage <<<'echo "700 windows after training (smote, seed 1): accuracy 56 %: results/t/real/seed0/E.h5"'
  expect_line "$(step)" '^real/seed0 +own +[0-9]+\.[0-9] s  accuracy 56 %$'
  local long
  long=$(printf 'word %.0s' {1..40})
  own_stage <<<"echo 'own  ###...   50 %  $long' >&2; echo 'own: $long' >&2; echo '$long'"
  step >line 2>messages
  expect_line "$(<line)" '^real/seed0 +own +[0-9.]+ s  word.*\.\.\.$'
  expect_equal "$(awk '{ print length }' line)" 100
  expect_equal "$(awk '/###/ { print length }' messages)" 100
  expect_line "$(<messages)" "own: ${long% }"
  expect_equal "$(grep -c "$long" results/t/real/seed0/own.log)" 3
}

# A classifier's scores and its description are separate steps, both by `diagnose`.
test_its_line_names_the_step() {
  own_stage <<<'echo "own: the reason" >&2; exit 66'
  expect_line "$(STEP_LOG=features step 2>&1 || true)" '^real/seed0 +features +failed with exit code 66'
  own_stage <<<'echo "made: 3 windows: results/t/real/seed0/A.h5"'
  expect_line "$(STEP_LOG=features step)" '^real/seed0 +features +[0-9]+\.[0-9] s  3 windows$'
}

test_passes_arguments_and_keeps_a_log() {
  own_stage <<<'printf "<%s>\n" "$@"; echo warned >&2'
  expect_equal "$(step --a 'two words' 2>&1 >/dev/null)" "$(printf '%-32s warned' real/seed0)"
  expect_equal "$(grep -v '^step:' results/t/real/seed0/own.log | sort)" \
    "$(printf '%s\n' '<--a>' '<two words>' 'fake/own --a two words' warned | sort)"
  expect_line "$(sed -n 2p results/t/real/seed0/own.log)" '^step: started at [0-9]+\.[0-9]{6}$'
  expect_line "$(tail -n 1 results/t/real/seed0/own.log)" '^step: exit 0 after [0-9]+\.[0-9] s$'
}

test_passes_the_exit_code() {
  own_stage <<<'echo "own: the reason" >&2; exit 66'
  expect_exit 66 step
  expect_line "$(step 2>&1 || true)" '^real/seed0 +own: the reason$'
  expect_line "$(step 2>&1 || true)" '^real/seed0 +own +failed with exit code 66'
  expect_line "$(<results/t/real/seed0/own.log)" '^step: exit 66 after'
}

test_two_makes_do_not_run_one_step_at_once() {
  own_stage <<<'mkdir only-one; touch started; until [[ -e go-on ]]; do sleep 0.05; done; rmdir only-one'
  step >/dev/null &
  wait_for started
  step >/dev/null 2>messages &
  until grep -qs waits messages; do sleep 0.05; done
  expect_line "$(<messages)" '^real/seed0 +own +waits: another make runs this step$'
  touch go-on
  expect_exit 0 wait %1
  expect_exit 0 wait %2
  expect_no_line "$(<messages)" "only-one"
}

# Runs the command of a step again, as a make with an older plan would.
again() { # its log
  local words
  read -ra words < <(command_of "$1")
  pipeline/step.sh "results/t/${1%/*}" "${words[0]#fake/}" "${words[@]:1}"
}

# Another make has finished the step since it was planned, or its inputs are unchanged: plan reports this.
test_a_step_that_is_no_longer_due_does_not_run() {
  describe
  local log which=(RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1" SEEDS=0)
  make --silent all BIN=fake "${which[@]}" >/dev/null
  rm calls
  export "${which[@]}" GOALS=all
  for log in ingest seed0/split seed0/smote/10to1/wdcnn/features tabulate; do
    export STEP_LOG=${log##*/}
    expect_line "$(PLANNED_AT=1 again "real/$log")" " is unchanged$"
    expect_line "$(ONLY_IF_DUE=yes PLANNED_AT=9999999999 again "real/$log")" " is unchanged$"
    expect_line "$(SUBMIT=env ONLY_IF_DUE=yes again "real/$log")" " is unchanged$"
  done
  unset STEP_LOG
  expect_equal "$(ran_with_features)" ""
  # planned after the other make's run, and by hand
  PLANNED_AT=9999999999 again real/seed0/split >/dev/null
  again real/seed0/split >/dev/null
  expect_equal "$(ran)" "2 split"
  # another setting, a lost file, and a case that plan cannot decide
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  PLANNED_AT=1 again real/seed0/smote/train >/dev/null
  rm results/t/real/tables.md
  ONLY_IF_DUE=yes again real/tabulate >/dev/null
  echo '[' >>pipeline/protocol.toml
  ONLY_IF_DUE=yes again real/seed0/split >/dev/null
  expect_equal "$(ran)" "1 split, 1 tabulate, 1 train"
}

# srun returns 0 when its node is lost.
test_a_step_that_did_not_remake_its_files_failed() {
  local made=results/t/real/seed0
  own_stage <<<'exit 0'
  mkdir -p $made
  echo old >$made/E.h5
  expect_exit 1 step --output $made/E.h5
  expect_line "$(step --output $made/E.h5 2>&1 || true)" \
    '^real/seed0 +own +failed with exit code 1 .*did not make results/t/real/seed0/E.h5; was its node lost'
  expect_line "$(<$made/own.log)" '^own: the stage exited with 0, but did not make .*E.h5'
  expect_line "$(tail -n 1 $made/own.log)" '^step: exit 1 after'
  own_stage <<<'echo old >new; mv new results/t/real/seed0/E.h5'
  expect_exit 0 step --output $made/E.h5
  # All of several files are required; none of them is an option of the stage.
  own_stage <<<'echo "$*" >results/t/real/seed0/A.h5'
  expect_exit 1 step --output-dir $made -- $made/A.h5 $made/B.h5
  expect_equal "$(<$made/A.h5)" "--output-dir $made"
  own_stage <<<'touch results/t/real/seed0/{A,B}.h5'
  expect_exit 0 step --output-dir $made -- $made/A.h5 $made/B.h5
}

# Unchanged numbers of figures are not rewritten: such a step does not remake any file.
test_a_submitted_step_without_named_files_reports_its_usage() {
  own_stage <<<'exit 0'
  expect_exit 0 step
  SUBMIT="env" expect_exit 1 step
  own_stage <<<'echo "step: used 1.00 s of processor time and 10 MB of memory" >&2'
  SUBMIT="env" expect_exit 0 step
}

test_reports_a_possible_lack_of_memory() {
  # shellcheck disable=SC2016
  own_stage <<<'kill -KILL $$'
  expect_line "$(step 2>&1 || true)" \
    'failed with exit code 137 after [0-9.]+ s: killed, perhaps for want of memory \(log'
  expect_line "$(<results/t/real/seed0/own.log)" '^own: killed, perhaps for want of memory$'
  own_stage <<<'echo "slurmstepd: error: Detected 1 oom_kill event in StepId=5.0." >&2; exit 1'
  expect_line "$(step 2>&1 || true)" 'failed with exit code 1 .*: killed, perhaps for want of memory'
}

test_missing_program_fails() {
  rm -f fake/own
  expect_exit 127 step
}

test_names_a_folder_that_cannot_be_created() {
  own_stage <<<'true'
  mkdir -p results/t && echo x >results/t/real
  expect_line "$(step 2>&1 || true)" 'cannot write results/t/real/seed0/own.log'
  expect_exit 1 step
}

test_submit_goes_before_the_stage() {
  own_stage <<<'echo "own: here"; echo "step: used 1.00 s of processor time and 10 MB of memory" >&2'
  expect_line "$(SUBMIT="env MARK=1 nice -n 1" step)" "here"
  expect_line "$(<results/t/real/seed0/own.log)" '^env MARK=1 nice -n 1 fake/own'
}

# A login shell's variables would change the bytes of outputs.
test_stages_get_one_thread_in_any_login_shell() {
  # shellcheck disable=SC2016
  own_stage <<<'echo "threads $OMP_NUM_THREADS $OPENBLAS_NUM_THREADS ${OMP_SCHEDULE-unset} ${GLIBC_TUNABLES//[^=]/}"'
  expect_line "$(step)" 'threads 1 1 unset ===$'
  expect_line "$(OMP_NUM_THREADS=3 OPENBLAS_NUM_THREADS=3 OMP_SCHEDULE=dynamic GLIBC_TUNABLES=a=1 step)" \
    'threads 1 1 unset ===$'
  # only simulate uses all cores
  mv fake/own fake/simulate
  expect_line "$(OMP_NUM_THREADS=3 pipeline/step.sh results/t/real simulate)" 'threads  1 unset ===$'
}

# (The scheduler decides which devices a job may use.)
test_stages_do_not_inherit_settings_of_libtorch() {
  # shellcheck disable=SC2016
  own_stage <<<'env | grep -cE "^(ATEN|DNNL|ONEDNN|TORCH|CUBLAS|NVIDIA_TF32)" || echo "devices $CUDA_VISIBLE_DEVICES"'
  expect_line "$(ATEN_CPU_CAPABILITY=default DNNL_MAX_CPU_ISA=SSE41 ONEDNN_MAX_CPU_ISA=SSE41 TORCH_NUM_THREADS=3 \
    CUBLAS_WORKSPACE_CONFIG=:16:8 NVIDIA_TF32_OVERRIDE=1 CUDA_VISIBLE_DEVICES=7 step)" 'devices 7$'
}

# Makes a stage that answers SIGTERM with a checkpoint and 75, as train does.
checkpointing_stage() {
  own_stage <<'STAGE'
trap 'echo saved >checkpoint; exit 75' TERM
touch started
for _ in {1..600}; do sleep 0.05; done # 30 s, where nobody ends it
STAGE
}

test_passes_a_signal_on_and_waits_for_the_stage() {
  checkpointing_stage
  local signal code
  for signal in TERM INT HUP; do
    rm -f checkpoint started
    # job control, because a background job without it ignores SIGINT
    set -m
    pipeline/step.sh results/t/real/seed0 own >/dev/null 2>messages &
    set +m
    wait_for started
    kill -$signal $!
    code=0
    wait $! || code=$?
    expect_equal "$signal $code $(<checkpoint)" "$signal 75 saved"
    expect_line "$(<messages)" 'interrupted after a checkpoint; the same command continues'
  done
}

# Makes a queue that passes USR1 on to its command and kills it on any other signal, as srun does. While a file `busy`
# exists it only waits.
queue() {
  cat >queue <<'QUEUE'
#!/bin/bash
trap 'echo USR1 >>queue-got' USR1
trap 'echo TERM >>queue-got; exit 1' TERM
touch queued
while [[ -e busy ]]; do sleep 0.05; done
"$@" &
child=$!
trap 'echo USR1 >>queue-got; kill -USR1 $child; again=yes' USR1
trap 'echo TERM >>queue-got; kill -KILL $child; again=yes' TERM
again=yes
while [[ $again ]]; do
  again=
  wait $child
  code=$?
done
exit $code
QUEUE
  chmod +x queue
}

test_a_stage_on_a_cluster_is_stopped_by_usr1() {
  queue
  own_stage <<'STAGE'
trap 'echo saved >checkpoint; exit 75' USR1
echo "step: started" >&2
touch started
for _ in {1..600}; do sleep 0.05; done # 30 s, where nobody ends it
STAGE
  local signal code
  for signal in TERM INT HUP QUIT; do
    rm -f checkpoint started queue-got
    set -m
    SUBMIT=./queue pipeline/step.sh results/t/real/seed0 own >/dev/null 2>messages &
    set +m
    wait_for started
    until stage_has_started results/t/real/seed0/own.log; do sleep 0.05; done
    # to the whole group, as a terminal does
    kill -$signal -- -$!
    code=0
    wait $! || code=$?
    expect_equal "$signal $code $(<checkpoint) $(<queue-got)" "$signal 75 saved USR1"
  done
}

# Makes a launcher that ends when it is signalled, as srun does some seconds after a requeue of its job: it does not
# wait for its stage, passes on no further output, and does not know the stage's exit code.
launcher_that_gives_up() { # its exit code
  cat >launcher <<LAUNCHER
#!/bin/bash
rm -f printed
"\$@" >/dev/null 2>printed &
child=\$!
until [[ -s printed ]]; do sleep 0.05; done
cat printed >&2
touch started
trap 'kill -USR1 \$child; exit $1' USR1
for _ in {1..600}; do sleep 0.05; done # 30 s, where nobody ends it
LAUNCHER
  chmod +x launcher
}
stop_step_of_launcher() { # expected exit code
  local model=results/t/real/seed0/model.h5
  rm -f started
  PATH=${path_of_step:-$PATH} SUBMIT=./launcher pipeline/step.sh results/t/real/seed0 own --output $model >/dev/null 2>messages &
  wait_for started
  until stage_has_started results/t/real/seed0/own.log; do sleep 0.05; done
  kill -TERM $!
  expect_exit "$1" wait $!
  expect_line "$(tail -n 1 results/t/real/seed0/own.log)" "^step: exit $1 after"
}

saves_slowly() {
  own_stage <<'STAGE'
trap 'sleep 1; echo saved >results/t/real/seed0/model.h5.checkpoint; exit 75' USR1
echo "step: started" >&2
for _ in {1..600}; do sleep 0.05; done # 30 s, where nobody ends it
STAGE
}

test_waits_for_a_stage_whose_launcher_gave_up() {
  saves_slowly
  local code
  for code in 0 1 137; do
    rm -f results/t/real/seed0/model.h5.checkpoint
    launcher_that_gives_up $code
    stop_step_of_launcher 75
    expect_equal "$(<results/t/real/seed0/model.h5.checkpoint)" saved
    expect_line "$(<messages)" 'interrupted after a checkpoint; the same command continues'
  done
}

# Slurm signals all processes of a job at once, including those that step.sh has just started.
test_waits_for_a_stage_if_all_processes_are_signalled() {
  saves_slowly
  mkdir path
  # shellcheck disable=SC2016
  printf '#!/bin/bash\nkill -TERM $$\n' >path/grep
  # shellcheck disable=SC2016
  printf '#!/bin/bash\n%s "$@"\nkill -TERM $$\n' "$(command -v sleep)" >path/sleep
  chmod +x path/*
  launcher_that_gives_up 0
  path_of_step=$PWD/path:$PATH stop_step_of_launcher 75
  expect_equal "$(<results/t/real/seed0/model.h5.checkpoint)" saved
}

# An earlier checkpoint is not evidence for this life.
test_a_stage_killed_before_its_checkpoint_failed() {
  mkdir -p results/t/real/seed0
  echo old >results/t/real/seed0/model.h5.checkpoint
  # shellcheck disable=SC2016
  own_stage <<'STAGE'
trap 'kill -KILL $$' USR1
echo "step: started" >&2
for _ in {1..600}; do sleep 0.05; done
STAGE
  launcher_that_gives_up 137
  CHECKPOINT_WITHIN=1 stop_step_of_launcher 143
}

test_a_step_in_a_queue_is_stopped_at_once() {
  queue
  touch busy
  SUBMIT=./queue pipeline/step.sh results/t/real/seed0 own >/dev/null 2>&1 &
  wait_for queued
  kill -TERM $!
  expect_exit 143 wait $!
  expect_equal "$(<queue-got)" TERM
  expect_line "$(<results/t/real/seed0/own.log)" '^step: exit 143 after'
}

test_time_in_a_queue_does_not_count() {
  queue
  own_stage <<<'echo "step: started" >&2; sleep 0.3; echo made >results/t/real/seed0/E.h5'
  touch busy
  (sleep 2 && rm busy) &
  SUBMIT=./queue step --output results/t/real/seed0/E.h5 >line
  expect_line "$(<line)" ' 0\.[3-9] s '
  expect_line "$(<results/t/real/seed0/own.log)" '^step: waited [123]\.[0-9] s$'
  expect_line "$(<results/t/real/seed0/own.log)" '^step: exit 0 after 0\.[3-9] s$'
}

test_interrupting_make_interrupts_the_stage() {
  checkpointing_stage
  mv fake/own fake/train
  printf 'name = "real"\n' >pipeline/datasets/real.toml
  set -m
  make --silent cells BIN=fake DATASETS=real METHODS=piae-dt SEEDS=0 >/dev/null 2>&1 &
  set +m
  wait_for started
  kill -TERM $!
  expect_exit 143 wait $!
  wait_for checkpoint
  [[ -e results/paper/real/seed0/C.h5 ]] || fail "what was finished is gone"
}

test_a_log_is_not_written_through_a_planted_link() {
  own_stage <<<'echo done'
  mkdir -p results/t/real/seed0
  echo precious >victim
  ln -s "$PWD/victim" results/t/real/seed0/own.log
  expect_exit 1 step
  expect_line "$(step 2>&1)" 'failed: cannot write results/t/real/seed0/own.log'
  expect_equal "$(<victim)" precious
}

test_a_log_that_is_a_pipe_does_not_block() {
  own_stage <<<'echo done'
  mkdir -p results/t/real/seed0
  mkfifo results/t/real/seed0/own.log
  expect_exit 1 timeout 10 pipeline/step.sh results/t/real/seed0 own
  expect_line "$(timeout 10 pipeline/step.sh results/t/real/seed0 own 2>&1)" \
    'failed: cannot write results/t/real/seed0/own.log'
}

run_tests "$@"
