#!/bin/bash
# How `make cluster` divides a grid among jobs, which needs no Slurm. On a real one: tests/slow/cluster/.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

plan() { make --silent cluster-plan BIN=fake RUN=t "$@"; }
# The words of a line of the plan, with one space between.
line_of() { awk -v name="$2" '$1 == name { $1 = $1; print }' <<<"$1"; }

# The jobs themselves, of a plan that is written down.
divide() { # steps, cores, minutes, further options of awk
  mkdir -p jobs_are
  rm -f jobs_are/*
  awk -f jobs/plan.awk -v cores="$2" -v minutes="$3" -v out=jobs_are -v papers=piae-dt "${@:4}" costs "$1"
}
step() { printf 'results/t/%s\t%s\t%s\tresults/t/%s/%s\n' "$1" "$2" "$3" "$1" "$4"; }

costs() {
  printf '%s\n' stage,dataset,method,classifier,ratio,seconds,megabytes ingest,cwru,,,,1,200 split,cwru,,,,1,100 \
    train,cwru,long,,,300,400 train,cwru,short,,,100,100 generate,cwru,long,,,10,100 tabulate,cwru,,,,2,50 \
    diagnose,cwru,long,wdcnn,10to1,30,90 diagnose,cwru,long,nearest,10to1,1,40 >costs
}

test_the_papers_grid_takes_few_submissions_and_little_more_than_is_needed() {
  local output
  output=$(plan DATASETS="cwru hit-sm" METHODS=paper)
  expect_equal "$(line_of "$output" records | cut -d' ' -f 1-3)" "records 1 4"
  expect_line "$output" '^cells +[1-9] +4 +0:[0-9]+ h +0\.[0-9] GB +1[67][0-9]+ '
  expect_line "$output" '^3 submissions, which ask for [0-9.]+ core-hours at most'
}

test_the_records_ask_for_the_memory_of_the_largest() {
  memory() { divide steps 1 1 | grep -P '^records' | cut -f 5; }
  costs
  printf '%s\n' ingest,large,,,,1,4000 ingest,small,,,,1,20 >>costs
  step large ingest '' records.h5 >steps
  local of_the_large
  of_the_large=$(memory)
  ((of_the_large >= 4000)) || fail "$of_the_large MB"
  step small ingest '' records.h5 >>steps
  expect_equal "$(memory)" "$of_the_large"
}

# A setting of a seed is a unit. Here each of two takes 50 + 1 s by the cost of piae-dt, and 10 + 1 s by that of long.
test_what_is_tried_beside_the_methods_is_divided_by_what_the_method_costs() {
  costs
  {
    for point in a-1 a-2; do
      for sweep in sweep sweep@long; do
        step cwru/seed0/$sweep/$point generate '' E.h5
        step cwru/seed0/$sweep/$point/10to1/nearest diagnose '' diagnosis.h5
      done
    done
    step cwru sweep@long long sweep@long.h5
  } >steps
  echo generate,cwru,piae-dt,,,50,100 >>costs
  expect_equal "$(divide steps 1 1 | grep -P '^(cells|unknown)')" \
    $'cells\t3\t1\t10\t400\t8\t124\nunknown\tsweep'
}

test_submit_alone_says_how_it_is_called() {
  expect_line "$(jobs/submit.sh --help)" '^usage: jobs/submit.sh \[--plan\] GOAL '
  expect_exit 0 jobs/submit.sh --help
  expect_line "$(jobs/submit.sh 2>&1 || true)" '^usage: jobs/submit.sh '
  expect_exit 2 jobs/submit.sh
  expect_exit 2 jobs/submit.sh --plan
}

test_a_thousand_and_one_seeds_are_an_array_that_slurm_takes() {
  local output
  # (Where an array may have 1001 tasks, as when nobody has said otherwise.)
  output=$(plan SEEDS="$(seq -s ' ' 0 1000)" METHODS="none smote" RATIOS="100to1 10to1" MINUTES=1 CORES=1)
  expect_line "$output" '^cells +[1-9][0-9]+ +1 '
  expect_line "$output" '^3 submissions'
}

test_other_questions_are_planned_too() {
  expect_line "$(make --silent cluster-plan sweep BIN=fake RUN=t SEEDS=0)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan readings BIN=fake SEEDS=100)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan identify BIN=fake RUN=t)" '^cells +[1-9] '
  expect_line "$(make --silent cluster-plan contrast BIN=fake RUN=t SEEDS=0)" '^cells +[2-9] '
  [[ ! -e results/t && ! -e calls ]] || fail "planning has made something"
}

test_only_what_is_missing_is_planned() {
  make --silent all BIN=fake RUN=t METHODS=smote RATIOS=10to1 SEEDS=0 >/dev/null 2>&1
  expect_equal "$(line_of "$(plan METHODS=smote RATIOS=10to1 SEEDS=0)" all | cut -d' ' -f 2)" 1
  # Train, generate, score and diagnose, and the split before them.
  expect_equal "$(line_of "$(plan METHODS=smote RATIOS=10to1 SEEDS="0 1")" cells | cut -d' ' -f 8)" 4
}

test_the_longest_is_begun_first_and_jobs_are_equally_long() {
  costs
  for seed in 0 1; do
    step "cwru/seed$seed/short" train short model.h5
    step "cwru/seed$seed/long" train long model.h5
    step "cwru/seed$seed/long" generate '' E.h5
  done >steps
  expect_line "$(divide steps 1 6)" $'^cells\t3\t1\t'
  expect_equal "$(cat jobs_are/cells.2)" "$(printf 'results/t/cwru/seed%d/short/model.h5\n' 1 0)"
  divide steps 2 60 >/dev/null
  expect_equal "$(xargs <jobs_are/cells.0)" "$(printf 'results/t/cwru/seed%s\n' 1/long/model.h5 1/long/E.h5 \
    0/long/model.h5 0/long/E.h5 1/short/model.h5 0/short/model.h5 | xargs)"
}

test_there_are_at_most_500_jobs_however_much_there_is_to_do() {
  costs
  for seed in {1..1200}; do step "cwru/seed$seed/long" train long model.h5; done >steps
  expect_line "$(divide steps 1 1)" $'^cells\t500\t1\t'
  expect_equal "$(cat jobs_are/cells.* | sort | uniq | wc -l)" 1200
}

test_time_and_memory_are_those_measured_with_some_to_spare() {
  costs
  for seed in 0 1; do step "cwru/seed$seed/long" train long model.h5; done >steps
  # 300 s twice and five minutes; 400 MB for each core and 300 for the rest.
  expect_line "$(divide steps 2 60)" $'^cells\t1\t2\t15\t1100\t2\t600$'
}

test_what_is_not_known_counts_as_the_longest_and_is_said() {
  costs
  step cwru/seed0/new train new model.h5 >steps
  local output
  output=$(divide steps 1 60)
  expect_line "$output" $'^cells\t1\t1\t15\t700\t1\t300$'
  expect_line "$output" $'^unknown\ttrain --method new$'
}

test_what_asks_for_cuda_has_jobs_of_its_own() {
  printf '\n[train.smote]\ndevice = "cuda"\n' >>pipeline/protocol.toml
  sed -i '0,/^\[train.smote\]/{//d}; /^neighbours = 4/d' pipeline/protocol.toml
  local output
  output=$(plan METHODS="smote vae" RATIOS=10to1 SEEDS="0 1")
  expect_equal "$(line_of "$output" cells | cut -d' ' -f 8)" 9
  # What follows the training runs in the same job.
  expect_equal "$(line_of "$output" cells-gpu | cut -d' ' -f 8)" 9
}

test_costs_are_the_mean_seconds_and_the_most_memory_of_the_logs() {
  local folder
  for folder in seed0 seed1; do
    mkdir -p "results/t/cwru/$folder/vae/1to1/wdcnn"
    echo "step: used ${folder#seed}2.00 s of processor time and ${folder#seed}50 MB of memory" \
      >"results/t/cwru/$folder/vae/train.log"
    echo "step: exit 0 after 5.0 s" >>"results/t/cwru/$folder/vae/train.log"
  done
  echo "step: used 9 s of processor time and 9 MB of memory"$'\n'"step: exit 75 after 1 s" \
    >results/t/cwru/seed0/vae/1to1/wdcnn/diagnose.log
  expect_equal "$(jobs/costs.sh results/t)" $'stage,dataset,method,classifier,ratio,seconds,megabytes\ntrain,cwru,vae,,,7.00,150'
}

test_costs_tell_classifiers_apart() {
  local folder
  for folder in 1to1/wdcnn 1to1/nearest; do
    mkdir -p "results/t/cwru/seed0/vae/$folder"
    echo "step: used ${#folder}.00 s of processor time and 50 MB of memory"$'\n'"step: exit 0 after 5.0 s" \
      >"results/t/cwru/seed0/vae/$folder/diagnose.log"
  done
  expect_equal "$(jobs/costs.sh results/t | tail -n 2)" \
    $'diagnose,cwru,vae,nearest,1to1,12.00,50\ndiagnose,cwru,vae,wdcnn,1to1,10.00,50'
}

# They wait for the same windows, so they are of one unit; the time of each is its own.
test_classifiers_go_into_the_job_of_their_method() {
  costs
  for folder in 10to1/{wdcnn,nearest,svm}; do step "cwru/seed0/long/$folder" diagnose '' diagnosis.h5; done >steps
  local output
  output=$(divide steps 1 1)
  # 30 s, 1 s, and of what nobody has measured as long as the longest step takes.
  expect_line "$output" $'^cells\t1\t1\t[0-9]+\t[0-9]+\t3\t331$'
  expect_line "$output" $'^unknown\tdiagnose by svm$'
  expect_equal "$(wc -l <jobs_are/cells.0)" 3
}

test_without_slurm_nothing_is_built_and_one_line_says_so() {
  mkdir path
  local program
  for program in make bash awk sed basename; do ln -s "$(command -v "$program")" path; done
  expect_exit 2 env PATH="$PWD/path" make cluster
  expect_line "$(PATH=$PWD/path make cluster 2>&1 || true)" 'there is no sbatch here'
  [[ ! -e build ]] || fail "something was built"
}

test_wrong_numbers_and_goals_are_refused() {
  expect_line "$(plan CORES=0 2>&1 || true)" "CORES: a whole number from 1 up, not '0'"
  expect_exit 2 make cluster-plan sweep contrast BIN=fake
}

# What stands beside them says only which question is meant.
test_what_stands_beside_status_and_cluster_stop_is_not_computed() {
  local goal program
  mkdir path
  for program in sbatch squeue scancel; do
    printf '#!/bin/bash\n' >path/$program
    chmod +x path/$program
  done
  PATH=$PWD/path:$PATH
  for goal in all cells sweep contrast identify readings; do
    for front in status cluster-stop help; do
      make --silent $front $goal BIN=fake SEEDS=100 RATIOS="10to1" >output 2>&1 || fail "$front $goal: $(<output)"
      [[ ! -e calls && $(ls results) == published ]] || fail "make $front $goal has computed: $(<calls)"
    done
  done
  expect_equal "$(make cluster-stop readings BIN=fake)" "no job of results/readings is in the queue"
  expect_equal "$(make --silent cluster-stop sweep BIN=fake RUN=t)" "no job of results/t is in the queue"
}

run_tests "$@"
