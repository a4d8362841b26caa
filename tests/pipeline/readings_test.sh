#!/bin/bash
# The readings of the paper as a graph: each has all settings of the base but those that it names.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

describe() {
  rm -f pipeline/datasets/*
  cat >pipeline/figures/draw.sh <<'SCRIPT'
#!/bin/bash
touch "${1%.csv}.svg" "${1%.csv}.pdf"
SCRIPT
  printf 'name = "real"\n' >pipeline/datasets/real.toml
  cat >pipeline/protocol.toml <<'TOML'
[train]
[train.piae-dt]
batches = "class"
[readings]
base = ["batches=mixed", "space=all"]
readings = ["batches=class", "batches=class+space=class"]
TOML
}

readings() { make --silent readings BIN=fake RUN=t DATASETS=real SEEDS=100 "$@"; }

test_a_reading_has_the_settings_of_the_base_but_those_that_it_names() {
  describe
  readings >/dev/null
  expect_equal "$(ran)" "6 diagnose, 3 generate, 1 ingest, 1 readings, 3 score, 1 split, 3 train"
  local cells=results/t/real/seed100/readings
  expect_equal "$(cd $cells && echo *)" "base batches-class batches-class+space-class"
  expect_line "$(<$cells/base/model.h5)" "--method piae-dt --batches mixed --space all --known"
  expect_line "$(<$cells/batches-class/model.h5)" "--method piae-dt --batches class --space all --known"
  expect_line "$(<$cells/batches-class+space-class/model.h5)" "--method piae-dt --batches class --space class --known"
  expect_line "$(<results/t/real/readings.csv)" "--run results/t --dataset real --ratios 10to1 1to1 --seeds 100 --published results/published"
  [[ -e results/t/real/readings.svg ]] || fail "no picture"
  readings >/dev/null
  expect_equal "$(ran)" ""
}

test_what_is_tried_once_more_is_computed_alone() {
  describe
  readings >/dev/null
  rm calls
  sed -i 's/readings = \["batches=class",/& "space=class",/' pipeline/protocol.toml
  readings >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 generate, 1 readings, 1 score, 1 train"
}

accuracy() { # reading, ratio, percent
  echo "cwru,$1,accuracy,$2,2,$3,1"
}

test_a_stepwise_search_goes_on_from_the_best() {
  {
    echo dataset,reading,quantity,ratio,seeds,mean,std
    accuracy base 10to1 60
    accuracy base 1to1 50
    accuracy space=class 10to1 65
    accuracy space=class 1to1 51
    accuracy batches=class 10to1 61
    accuracy batches=class 1to1 51
    accuracy keep=final 10to1 99 # without 1to1
    accuracy batches=other 10to1 40
    accuracy batches=other 1to1 40
    accuracy batches=other+space=class 10to1 40
    accuracy batches=other+space=class 1to1 40
    echo cwru,base,mmd,,2,100,1
    echo cwru,published,accuracy,10to1,1,99,
    echo cwru,published,accuracy,1to1,1,99,
  } >readings.csv
  expect_equal "$(awk -f pipeline/rank_readings.awk readings.csv)" "$(printf '%s\n' ' 58.00  space=class' ' 56.00  batches=class' \
    ' 55.00  base' ' 40.00  batches=other' ' 40.00  batches=other+space=class' \
    'to try next: batches=class+space=class' 'to try next: keep=final+space=class')"
}

test_the_table_is_of_what_is_asked_for_also_after_less_was() {
  describe
  readings SEEDS="100 101" >/dev/null
  readings SEEDS=100 >/dev/null
  readings SEEDS="100 101" >/dev/null
  expect_line "$(<results/t/real/readings.csv)" "--ratios 10to1 1to1 --seeds 100 101 "
  readings SEEDS="100 101" RATIOS=10to1 >/dev/null
  readings SEEDS="100 101" >/dev/null
  expect_line "$(<results/t/real/readings.csv)" "--ratios 10to1 1to1 --seeds 100 101 "
}

test_its_seeds_and_run_are_its_own() {
  describe
  make --silent -n readings BIN=fake DATASETS=real | grep -oE 'results/[a-z]+/real/seed[0-9]+' | sort -u >folders
  expect_equal "$(paste -sd' ' folders)" \
    "$(echo results/readings/real/seed10{0,1,2,3,4})"
}

test_no_reading_is_refused() {
  describe
  sed -i '/^readings = /d' pipeline/protocol.toml
  expect_line "$(readings 2>&1)" '\[readings\] of pipeline/protocol.toml names none'
}

run_tests "$@"
