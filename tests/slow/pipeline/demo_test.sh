#!/bin/bash
# The demo as a newcomer runs it: built from nothing, its answers, and the files that it names.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

demo() { make demo "$@" 2>&1; }

test_the_demo_ends_with_three_answers_and_two_files() {
  skip_where_nothing_draws
  ln -s "$project"/{CMakeLists.txt,LICENSE,packaging,src,stages} .
  local output answers
  output=$(demo) || fail "$output"
  expect_equal "$(ls build/bin)" "$(printf '%s\n' classify demo_answers diagnose figures generate plan read_raw report score \
    simulate split tabulate train)"
  answers=$(sed -n '/^Three questions/,$p' <<<"$output")
  # Numbers may differ by processor, words may not.
  expect_equal "$(sed -E 's/[0-9]+ %/N %/g; s/\([0-9]+ ->/(N ->/' <<<"$answers")" \
    "Three questions about a simulated bearing (percent correct, 3 seeds):

1. A few windows of each fault are known. What helps a classifier of waveforms?
   shift (N -> N %), not piae-dt (N %). Spectra do not need help: N %.
2. Faults are known at 1800 rpm, the machine runs at 1200 rpm. What helps?
   strike-twin (N -> N % by wdcnn-spectra); shift reaches N %.
3. No fault was ever recorded. Can one be diagnosed anyway?
   Yes: N % correct by exclusion-rule; recording.txt: outer, correct.

Open results/demo/report.html    tables and figures
     results/demo/recording.svg  the diagnosis of recording.txt"
  expect_equal "$(awk 'length > 80' <<<"$answers")" ""
  grep -q '<figure' results/demo/report.html || fail "the report has no figure"
  grep -q 'recording.txt: outer' results/demo/recording.svg || fail "the picture names no fault"

  expect_equal "$(demo | sed -n '/^Three questions/,$p')" "$answers" # nothing is left to do
  expect_equal "$(demo | grep -cE ' (train|generate|diagnose|score) ')" 0

  rm results/demo/recording* # two simultaneous demos both make them
  demo >other &
  local other=$!
  demo >/dev/null || fail "one of two demos at once failed"
  wait $other || fail "$(<other)"
}

test_the_demo_refuses_its_fixed_variables() {
  expect_line "$(demo BIN="$programs" METHODS=smote || true)" 'make demo: METHODS cannot be chosen; .make all. accepts it'
  expect_line "$(demo BIN="$programs" cells || true)" 'make demo: cannot be combined with other targets; run it alone'
}

run_tests "$@"
