#!/bin/bash
# Promises of CONTRIBUTING.md to newcomers, with the built programs: a method takes one class and one line of the
# catalogue, a classifier one function and one line, a figure one function and one script, a data set one TOML file, and
# the grid knows them all.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

shown=$(realpath "${PIAE_SHOWN:-$project/build/tests/slow/contributing}")

# Lays out the programs, with those that contain the shown method instead of the others.
lay_out() {
  mkdir bin
  ln -s "$programs"/* bin
  ln -sf "$shown"/bin/* bin
  cp "$shown"/pipeline/figures/* pipeline/figures
  cp "$project/tests/reference/protocol.toml" pipeline
}

# Writes a recording: an impact every 80 samples, with ringing at a level that increases from class to class, and noise.
record() { # file, level
  awk -v level="$2" 'BEGIN {
    srand(level + 1)
    for (i = 0; i < 70000; ++i) {
      t = i % 80
      printf "%.6f\n", level * exp(-t / 12) * sin(t * (0.8 + 0.1 * level)) + 0.2 * (rand() - 0.5)
    }
  }' >"$1"
}

describe_rig() {
  mkdir recordings
  {
    cat <<'RIG'
name = "rig"
sample_rate_hz = 12000
shaft_speed_rpm = 1500
[bearing]
balls = 9
ball_diameter_mm = 7.94
pitch_diameter_mm = 39
inner_raceway_mm = 31.06
outer_raceway_mm = 46.94
contact_angle_deg = 0
RIG
    local class level=0
    for class in none inner outer; do
      record "recordings/$class.csv" $((level++))
      printf '[[class]]\nname = "%s-1"\ndefect = "%s"\n' $class $class
      [[ $class == none ]] || echo 'defect_size_mm = 0.3'
      printf '[[record]]\nclass = "%s-1"\nfile = "%s.csv"\nvariable = "1"\nsample_rate_hz = 12000\n' \
        $class $class
    done
  } >pipeline/datasets/rig.toml
}

test_the_method_and_data_set_of_contributing_run_in_the_grid() {
  skip_where_nothing_draws
  lay_out
  describe_rig
  bin/ingest --check --description pipeline/datasets/rig.toml --data-dir recordings >messages 2>&1 ||
    fail "$(<messages)"
  make --silent all BIN=bin RUN=new DATASETS=rig METHODS="none reverse" RATIOS="100to1 10to1" \
    SEEDS=0 CLASSIFIERS="wdcnn wdcnn-magnitude" DATA_DIR=recordings >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<results/new/rig/accuracy.csv)" '^rig,reverse,wdcnn,10to1,45,1,'
  expect_line "$(<results/new/rig/accuracy.csv)" '^rig,reverse,wdcnn-magnitude,10to1,45,1,'
  expect_line "$(<results/new/rig/tables.md)" 'reverse'
  expect_line "$(<results/new/rig/figures/seed-range.svg)" '10to1'
  [[ -f results/new/rig/figures/seed-range@wdcnn-magnitude.svg ]] || fail "the shown classifier has no picture"
}

test_the_method_of_contributing_plays_backwards() {
  lay_out
  describe_rig
  make --silent cells BIN=bin RUN=new DATASETS=rig METHODS=reverse RATIOS=10to1 SEEDS=0 \
    DATA_DIR=recordings >messages 2>&1 || fail "$(<messages)"
  local cell=results/new/rig/seed0
  # Window 0 of E is the reversed window 0 of its class in C.
  first_window() { h5dump -d "/windows[0,0;;1,1024;]" -y -w 1 "$1" | grep -oE '^ +-?[0-9][0-9.e+-]*' | tr -d ' '; }
  expect_equal "$(first_window $cell/reverse/E.h5)" "$(first_window $cell/C.h5 | tac)"
}

test_the_goal_of_contributing_runs_its_stage() {
  lay_out
  describe_rig
  sed -i 's/^grid_goals := /&counts /' Makefile
  local which=(--silent counts BIN=bin RUN=new DATASETS=rig SEEDS="0 1" DATA_DIR=recordings)
  make "${which[@]}" >messages 2>&1 || fail "$(<messages)"
  expect_equal "$(<results/new/rig/seed1/counts.csv)" $'class,windows\nnone-1,0\ninner-1,5\nouter-1,5'
  expect_equal "$(make "${which[@]}")" ""
  rm results/new/rig/seed0/counts.csv
  expect_equal "$(stages_of "$(make "${which[@]}")")" "count"
}

run_rig() {
  make --silent cells BIN=bin RUN=new DATASETS=rig METHODS=none RATIOS=100to1 SEEDS=0 CLASSIFIERS=nearest \
    DATA_DIR=recordings "$@"
}
stages_of() { awk '$2 ~ /^[a-z]+$/ { print $2 }' <<<"$1" | xargs; }

test_a_replaced_recording_is_noticed() {
  lay_out
  describe_rig
  expect_equal "$(stages_of "$(run_rig)")" "ingest split diagnose"
  expect_equal "$(run_rig)" ""
  # The same recordings: rewritten, in another folder, by another path, or missing.
  touch recordings/outer.csv
  cp -r recordings copies
  expect_equal "$(run_rig)$(run_rig DATA_DIR=copies)$(run_rig DATA_DIR="$PWD/copies/")$(run_rig DATA_DIR=none)" ""
  # Another recording with the same length and time.
  tr 1 2 <recordings/outer.csv >other.csv
  touch -r recordings/outer.csv other.csv
  mv other.csv recordings/outer.csv
  expect_line "$(run_rig -n)" 'step.sh results/new/rig ingest '
  expect_equal "$(stages_of "$(run_rig)")" "ingest split diagnose"
  expect_equal "$(run_rig)" ""
  expect_equal "$(stages_of "$(run_rig DATA_DIR=copies)")" "ingest split diagnose"
}

# Records themselves name their recordings.
test_records_without_a_journal_are_compared_by_their_digests() {
  lay_out
  describe_rig
  run_rig >/dev/null
  rm results/new/.journal
  expect_equal "$(run_rig)" ""
  record recordings/outer.csv 3
  expect_equal "$(stages_of "$(run_rig)")" "ingest split diagnose"
}

# Outputs of a failed step are still due.
test_an_unreadable_recording_leaves_the_step_due() {
  lay_out
  describe_rig
  run_rig >/dev/null
  cp recordings/outer.csv good.csv
  echo x >>recordings/outer.csv
  expect_line "$(run_rig 2>&1)" 'ingest: recordings/outer.csv, line 70001: '
  expect_line "$(run_rig 2>&1)" 'ingest: recordings/outer.csv, line 70001: '
  cp good.csv recordings/outer.csv # the recording that the records were made from
  expect_equal "$(run_rig)" ""
}

# A machine with a sound bearing of unknown geometry: methods without kinematics run.
test_a_fault_of_another_part_of_the_machine() {
  lay_out
  describe_rig
  sed -i '/^\[bearing\]/,/^contact_angle_deg/d; /^defect_size_mm/d; s/^defect = "\(inner\|outer\)"/defect = "other"/' \
    pipeline/datasets/rig.toml
  bin/ingest --check --description pipeline/datasets/rig.toml --data-dir recordings --picture rig.svg >messages 2>&1 ||
    fail "$(<messages)"
  expect_no_line "$(<messages)" BPFO
  make --silent all BIN=bin RUN=new DATASETS=rig METHODS="none shift" RATIOS="100to1 10to1" SEEDS=0 \
    CLASSIFIERS="wdcnn nearest" DATA_DIR=recordings >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<results/new/rig/seed0/shift/score.log)" "without fault line: inner-1, outer-1, because the defect is 'other'"
  expect_no_line "$(<messages)" warning
  expect_line "$(<results/new/rig/accuracy.csv)" '^rig,shift,wdcnn,10to1,45,1,'
  bin/verify results/new/rig/records.h5 results/new/rig/seed0/*/*.h5 || fail "not verified"
  local refused
  for refused in piae-dt-phase ae piae-dt-zero; do
    expect_exit 2 run_rig METHODS="shift $refused" RATIOS=10to1
    expect_line "$(run_rig METHODS="shift $refused" RATIOS=10to1 2>&1 || true)" \
      "METHODS: $refused cannot be run; the description of rig lacks what they need: .*; choose METHODS=\"shift\""
  done
  # Without a choice of methods, the skipped ones are named.
  expect_line "$(make -n cells BIN=bin RUN=new DATASETS=rig SEEDS=0 DATA_DIR=recordings 2>&1)" \
    '^rig: left out: dynamics piae-dt ae physics piae-dt-cnn piae-dt-rnn piae-dt-phase; the description lacks '
  bin/diagnose --test results/new/rig/seed0/A.h5 --normal results/new/rig/seed0/B.h5 --known results/new/rig/seed0/C.h5 \
    --ratio 100to1 --classifier envelope-rule --seed 0 --output rule.h5 >messages 2>&1 && fail "a rule named it"
  expect_line "$(<messages)" "has defect 'other', which does not have a fault line"
}

test_a_defect_of_unknown_size() {
  lay_out
  describe_rig
  sed -i '/^defect_size_mm/d' pipeline/datasets/rig.toml
  run_rig METHODS="none shift" RATIOS="100to1 10to1" >messages 2>&1 || fail "$(<messages)"
  bin/train --method piae-dt --known results/new/rig/seed0/C.h5 --seed 0 --output m.h5 >messages 2>&1 &&
    fail "trained without a size"
  expect_line "$(<messages)" 'C.h5: piae-dt needs defect_size_mm of class inner-1, .*; use a method that does not need it: smote, '
}

run_tests "$@"
