#!/bin/bash
# The grid as a graph: what is made of what, and where.
# shellcheck source-path=SCRIPTDIR disable=SC2119
source "${0%/*}/../../pipeline/small_grid.sh"

test_makes_every_cell_once() {
  describe
  grid -j4 >/dev/null
  expect_equal "$(ran)" "24 diagnose, 8 generate, 1 ingest, 8 score, 1 simulate, 4 split, 2 tabulate, 8 train"
}

test_ends_with_the_summary_of_every_data_set() {
  finished_grid
  echo "of real" >results/t/real/summary.txt
  echo "of made" >results/t/made/summary.txt
  expect_equal "$(grid 2>&1)" "$(printf '%s\n' 'of real' 'of made' \
    'tables and artefacts: results/t/real/' 'tables and artefacts: results/t/made/')"
}

test_gives_each_stage_its_files() {
  finished_grid
  local r=results/t/real s=results/t/.settings
  expect_equal "$(<$r/records.h5)" \
    "ingest --data-dir data --description $s/datasets/real.toml --output $r/records.h5"
  expect_equal "$(<results/t/made/records.h5)" \
    "simulate --description $s/datasets/made.toml --output results/t/made/records.h5"
  expect_equal "$(<$r/seed1/A.h5)" \
    "split --config $s/split.toml --records $r/records.h5 --seed 1 --protocol random --output-dir $r/seed1"
  expect_equal "$(<$r/seed1/smote/model.h5)" \
    "train --config $s/train.smote.toml --method smote --known $r/seed1/C.h5 --seed 1 --output $r/seed1/smote/model.h5"
  expect_equal "$(<$r/seed1/smote/E.h5)" \
    "generate --config $s/generate.toml --model $r/seed1/smote/model.h5 --seed 1 --output $r/seed1/smote/E.h5"
  expect_equal "$(<$r/seed1/smote/score.h5)" \
    "score --config $s/score.toml --generated $r/seed1/smote/E.h5 --real $r/seed1/D.h5 --output $r/seed1/smote/score.h5"
  local windows="--test $r/seed1/A.h5 --normal $r/seed1/B.h5 --known $r/seed1/C.h5"
  expect_equal "$(<$r/seed1/smote/10to1/wdcnn/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --generated $r/seed1/smote/E.h5 --ratio 10to1 --seed 1 --reproducible --output $r/seed1/smote/10to1/wdcnn/diagnosis.h5"
  expect_equal "$(<$r/seed1/none/100to1/wdcnn/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 100to1 --seed 1 --reproducible --output $r/seed1/none/100to1/wdcnn/diagnosis.h5"
  expect_equal "$(<$r/accuracy.csv)" \
    "tabulate --config $s/tabulate.real.toml --run results/t --dataset real --methods none smote piae-dt --ratios 100to1 10to1 1to1 --seeds 0 1 --classifiers wdcnn --published results/published"
}

test_only_the_oracle_sees_real_windows_and_it_has_no_score() {
  describe
  grid DATASETS=real METHODS="smote oracle" SEEDS=0 >/dev/null
  expect_equal "$(ran)" "4 diagnose, 2 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 2 train"
  local r=results/t/real s=results/t/.settings
  expect_equal "$(<$r/seed0/oracle/model.h5)" \
    "train --config $s/train.oracle.toml --method oracle --real $r/seed0/D.h5 --known $r/seed0/C.h5 --seed 0 --output $r/seed0/oracle/model.h5"
  expect_no_line "$(<$r/seed0/smote/model.h5)" "D.h5"
}

features() {
  make --silent --file=pipeline/grid.mk features results=results/t RUN=t BIN=fake PROTOCOL=random \
    DATASETS=real METHODS="none smote oracle" RATIOS="1to1 100to1 10to1" SEEDS="10 2" "$@"
}

test_features_are_kept_once_for_each_method() {
  describe
  features >/dev/null
  expect_equal "$(ran_with_features)" "3 features, 2 generate, 1 ingest, 1 split, 2 train"
  local r=results/t/real s=results/t/.settings
  expect_equal "$(cd $r && echo seed*/*/*/*/features.h5)" \
    "seed2/none/100to1/wdcnn/features.h5 seed2/oracle/1to1/wdcnn/features.h5 seed2/smote/1to1/wdcnn/features.h5"
  local windows="--test $r/seed2/A.h5 --normal $r/seed2/B.h5 --known $r/seed2/C.h5"
  expect_equal "$(<$r/seed2/smote/1to1/wdcnn/features.h5)" \
    "diagnose --config $s/diagnose.toml $windows --generated $r/seed2/smote/E.h5 --ratio 1to1 --seed 2 --reproducible --keep-features --output $r/seed2/smote/1to1/wdcnn/features.h5"
  expect_equal "$(<$r/seed2/none/100to1/wdcnn/features.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 100to1 --seed 2 --reproducible --keep-features --output $r/seed2/none/100to1/wdcnn/features.h5"
  features >/dev/null
  expect_equal "$(ran_with_features)" ""
  sed -i 's/^epochs = 50/epochs = 60/' pipeline/protocol.toml
  features >/dev/null
  expect_equal "$(ran_with_features)" "3 features"
}

test_features_are_made_with_the_tables_and_once() {
  describe
  grid >/dev/null
  expect_equal "$(grep -c ^features calls)" 6 # of seed 0, two data sets, three methods
  grid >/dev/null
  expect_equal "$(grep -c ^features calls)" 6
}

test_the_report_is_of_the_cells_that_were_asked_for() {
  describe
  grid >/dev/null
  expect_equal "$(tr -s ' ' <reports | sed 's/ $//')" \
    "report: --run results/t --datasets real made --methods none smote piae-dt --ratios 100to1 10to1 1to1 --seeds 0 1 --classifiers wdcnn --published results/published"
}

test_features_and_diagnosis_have_logs_of_their_own() {
  finished_grid
  local log=results/t/real/seed0/smote/1to1/wdcnn/diagnose.log
  cp $log before
  features SEEDS="0 1" >/dev/null
  expect_equal "$(<$log)" "$(<before)"
  expect_line "$(<results/t/real/seed0/smote/1to1/wdcnn/features.log)" "--keep-features"
}

test_each_classifier_has_a_folder() {
  describe
  grid DATASETS=real METHODS=smote RATIOS=10to1 SEEDS=0 CLASSIFIERS="wdcnn wdcnn-spectrum" >/dev/null
  expect_equal "$(ran_with_features)" "2 diagnose, 1 features, 1 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 1 train"
  local r=results/t/real s=results/t/.settings
  local windows="--test $r/seed0/A.h5 --normal $r/seed0/B.h5 --known $r/seed0/C.h5 --generated $r/seed0/smote/E.h5"
  expect_equal "$(<$r/seed0/smote/10to1/wdcnn/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 10to1 --seed 0 --reproducible --output $r/seed0/smote/10to1/wdcnn/diagnosis.h5"
  expect_equal "$(<$r/seed0/smote/10to1/wdcnn-spectrum/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 10to1 --classifier wdcnn-spectrum --seed 0 --reproducible --output $r/seed0/smote/10to1/wdcnn-spectrum/diagnosis.h5"
  [[ -f $r/seed0/smote/10to1/wdcnn-spectrum/diagnose.log ]] || fail "no log of its own"
  expect_line "$(<$r/accuracy.csv)" '--classifiers wdcnn wdcnn-spectrum --published'
}

test_the_baseline_has_its_nearest_neighbour_whatever_the_classifiers() {
  describe
  local classifiers
  for classifiers in wdcnn-spectra "nearest wdcnn"; do
    make --silent cells BIN=fake RUN=t DATASETS=real METHODS="none smote" RATIOS="100to1 10to1 1to1" SEEDS=0 \
      CLASSIFIERS="$classifiers" >/dev/null
    expect_line "$(<results/t/real/seed0/none/100to1/nearest/diagnosis.h5)" '--ratio 100to1 --classifier nearest '
    expect_equal "$(cd results/t/real/seed0 && find . -name nearest | wc -l)" \
      "$([[ $classifiers == *nearest* ]] && echo 3 || echo 1)"
    rm -r results
  done
}

# Without the paper's classifier there are no features of it.
test_what_another_classifier_needs_is_made_and_no_more() {
  describe
  grid DATASETS=real METHODS="none smote" SEEDS=0 CLASSIFIERS=wdcnn-envelope >/dev/null
  expect_equal "$(ran_with_features)" "4 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 1 train"
  [[ ! -e results/t/real/seed0/smote/10to1/wdcnn/diagnosis.h5 ]] || fail "the paper's classifier was asked, too"
}

test_tables_have_the_cells_of_other_classifiers_too() {
  describe
  grid DATASETS=real CLASSIFIERS="wdcnn wdcnn-spectrum" >/dev/null
  rm calls
  grid DATASETS=real CLASSIFIERS="wdcnn wdcnn-spectrum" >/dev/null
  expect_equal "$(ran)" ""
  # A part is asked for: what else is there is neither made again nor left out.
  grid DATASETS=real SEEDS=0 >/dev/null
  expect_equal "$(ran)" "" # the tables are of the same cells
  touch results/t/real/seed1/smote/10to1/wdcnn-spectrum/diagnosis.h5
  grid DATASETS=real SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  # An option of all makes what is asked for again; the others are out of date.
  sed -i 's/^epochs = 50/epochs = 60/' pipeline/protocol.toml
  grid DATASETS=real SEEDS=0 METHODS=smote >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 tabulate"
  expect_line "$(<results/t/real/accuracy.csv)" ' --leave-out .*seed0/smote/10to1/wdcnn-spectrum/diagnosis.h5 '
  expect_line "$(<results/t/real/accuracy.csv)" ' --leave-out .*seed1/none/100to1/nearest/diagnosis.h5 '
  expect_no_line "$(<results/t/real/accuracy.csv)" ' seed0/smote/10to1/wdcnn/diagnosis.h5 '
}

cells_of() { make -n cells BIN=fake RUN=t DATASETS=real SEEDS=0 RATIOS="100to1 1to1" "$@" 2>&1; }
trained() { sed -nE 's/.* train .* --method ([^ ]+) .*/\1/p' | xargs; }

# Who chooses no methods sees those that are recommended beside the paper's; these have a name of their own.
test_methods_are_the_papers_and_what_is_recommended() {
  describe
  local papers="dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn"
  expect_equal "$(cells_of | trained)" "$papers piae-dt-phase shift"
  expect_equal "$(cells_of METHODS=paper | trained)" "$papers"
  expect_equal "$(cells_of METHODS="paper oracle" | trained)" "$papers oracle"
  expect_line "$(make help BIN=fake)" "^  METHODS .* \\[none $papers piae-dt-phase shift\\]"
  expect_line "$(make help)" "^  METHODS .* piae-dt-phase shift\\]" # before anything is built
  expect_equal "$(make status cells BIN=fake RUN=t DATASETS=real SEEDS=0 METHODS=paper | awk '$1 == "all" { print $2 }')" 65
}

test_none_only_without_generated_windows() {
  finished_grid
  expect_equal "$(cd results/t/real/seed0 && echo {none,smote}/*to1)" "none/100to1 smote/10to1 smote/1to1"
}

test_blocked_protocol_has_its_own_folder() {
  finished_grid
  grid PROTOCOL=blocked DATASETS=real SEEDS=0 METHODS=none >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split, 1 tabulate"
  expect_line "$(<results/t-blocked/real/seed0/A.h5)" "--protocol blocked"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

# As a job on a cluster asks for them: its goals are files.
test_a_run_may_be_called_as_a_goal_is() {
  describe
  local run
  for run in sweep mysweep readings; do
    make --silent -f pipeline/grid.mk BIN=fake RUN=$run results=results/$run DATASETS=real METHODS=smote \
      RATIOS=10to1 SEEDS=0 LIBTORCH=off PROTOCOL=random results/$run/real/seed0/smote/10to1/wdcnn/diagnosis.h5 >/dev/null
  done
}

test_a_single_artefact_is_a_goal() {
  describe
  make --silent BIN=fake RUN=t DATASETS=real results/t/real/seed3/piae-dt/model.h5 >/dev/null
  expect_equal "$(ran)" "1 ingest, 1 split, 1 train"
}

test_the_papers_methods_those_recommended_and_all_ratios_run_where_none_are_given() {
  describe
  make --silent all BIN=fake RUN=t DATASETS=real SEEDS=0 >/dev/null
  expect_line "$(<results/t/real/accuracy.csv)" \
    "--methods none dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn piae-dt-phase shift --ratios 100to1 50to1 25to1 10to1 5to1 2to1 1to1 --seeds 0 "
}

test_several_goals_go_to_one_make() {
  describe
  make --silent -j2 records cells results/t/real/seed0/A.h5 BIN=fake RUN=t DATASETS=real METHODS=smote \
    RATIOS=10to1 SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 train"
}

run_tests "$@"
