#!/bin/bash
# The grid as a graph: what is made, what is made again after a change, what a failure leaves.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# Two data sets, so that what belongs to one of them can be told apart.
describe() {
  rm -f pipeline/datasets/*
  printf 'name = "real"\nsha256 = "#1" # a comment\n' >pipeline/datasets/real.toml
  printf 'name = "made"\n[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  cat >pipeline/protocol.toml <<'TOML'
[split]
window = 1024  # samples
[train]
epochs = 200
[train.smote]
neighbours = 4
[train.piae-dt]
layers = [
  # depth
  3,
]
[generate]
count = 495
[score]
kernels = 5
[diagnose]
epochs = 50
TOML
}

grid() {
  make --silent all BIN=fake RUN=t DATASETS="real made" METHODS="none smote piae-dt" \
    RATIOS="100to1 10to1 1to1" SEEDS="0 1" "$@"
}

# The stages that ran since the last call, counted: "12 diagnose, 4 train". With `all`, also the trainings
# whose features are kept.
ran() {
  [[ -e calls ]] || return 0
  awk -v all="${1:-}" '$1 != "features" || all { n[$1]++ } END { for (stage in n) print n[stage], stage }' calls | sort -k2 |
    paste -sd, | sed 's/,/, /g'
  rm calls
}

finished_grid() {
  describe
  grid >/dev/null 2>&1
  rm calls
}

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
  expect_equal "$(<$r/seed1/smote/10to1/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --generated $r/seed1/smote/E.h5 --ratio 10to1 --seed 1 --reproducible --output $r/seed1/smote/10to1/diagnosis.h5"
  expect_equal "$(<$r/seed1/none/100to1/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 100to1 --seed 1 --reproducible --output $r/seed1/none/100to1/diagnosis.h5"
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
  expect_equal "$(ran all)" "3 features, 2 generate, 1 ingest, 1 split, 2 train"
  local r=results/t/real s=results/t/.settings
  expect_equal "$(cd $r && echo seed*/*/*/features.h5)" \
    "seed2/none/100to1/features.h5 seed2/oracle/1to1/features.h5 seed2/smote/1to1/features.h5"
  local windows="--test $r/seed2/A.h5 --normal $r/seed2/B.h5 --known $r/seed2/C.h5"
  expect_equal "$(<$r/seed2/smote/1to1/features.h5)" \
    "diagnose --config $s/diagnose.toml $windows --generated $r/seed2/smote/E.h5 --ratio 1to1 --seed 2 --reproducible --keep-features --output $r/seed2/smote/1to1/features.h5"
  expect_equal "$(<$r/seed2/none/100to1/features.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 100to1 --seed 2 --reproducible --keep-features --output $r/seed2/none/100to1/features.h5"
  features >/dev/null
  expect_equal "$(ran all)" ""
  sed -i 's/^epochs = 50/epochs = 60/' pipeline/protocol.toml
  features >/dev/null
  expect_equal "$(ran all)" "3 features"
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
  local log=results/t/real/seed0/smote/1to1/diagnose.log
  cp $log before
  features SEEDS="0 1" >/dev/null
  expect_equal "$(<$log)" "$(<before)"
  expect_line "$(<results/t/real/seed0/smote/1to1/features.log)" "--keep-features"
}

# The paper's classifier stays where it was when there was no other.
test_other_classifiers_have_folders_of_their_own() {
  describe
  grid DATASETS=real METHODS=smote RATIOS=10to1 SEEDS=0 CLASSIFIERS="wdcnn wdcnn-spectrum" >/dev/null
  expect_equal "$(ran all)" "2 diagnose, 1 features, 1 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 1 train"
  local r=results/t/real s=results/t/.settings
  local windows="--test $r/seed0/A.h5 --normal $r/seed0/B.h5 --known $r/seed0/C.h5 --generated $r/seed0/smote/E.h5"
  expect_equal "$(<$r/seed0/smote/10to1/diagnosis.h5)" \
    "diagnose --config $s/diagnose.toml $windows --ratio 10to1 --seed 0 --reproducible --output $r/seed0/smote/10to1/diagnosis.h5"
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
  expect_equal "$(ran all)" "4 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 tabulate, 1 train"
  [[ ! -e results/t/real/seed0/smote/10to1/diagnosis.h5 ]] || fail "the paper's classifier was asked, too"
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
  expect_no_line "$(<results/t/real/accuracy.csv)" ' seed0/smote/10to1/diagnosis.h5 '
}

# What a run would lack at its very end is missed before its first step.
test_published_tables_that_were_removed_are_missed_at_the_start() {
  describe
  rm -r results
  expect_exit 2 grid
  expect_line "$(grid 2>&1 || true)" 'results/published holds no table: .*git checkout results/published'
  expect_equal "$(ran)" ""
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=none RATIOS=100to1 SEEDS=0 >/dev/null # needs none
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split"
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

test_second_run_does_nothing() {
  finished_grid
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_dry_run_shows_the_graph_and_makes_nothing() {
  describe
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 62
  expect_equal "$(ran)" ""
  finished_grid
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 0
}

# make itself takes files that one step makes together for as old as they were.
test_a_dry_run_shows_all_that_a_new_split_brings_back() {
  finished_grid
  sed -i 's/^window = 1024/window = 512/' pipeline/protocol.toml
  expect_equal "$(grid -n | grep -c pipeline/step.sh)" 60
  describe
  rm results/t/real/seed0/B.h5
  expect_line "$(grid -n)" 'step.sh results/t/real/seed0 split .* --records results/t/real/records.h5 '
  expect_equal "$(ran)" ""
}

test_touching_and_comments_change_nothing() {
  finished_grid
  touch pipeline/*.toml pipeline/datasets/*.toml fake/*
  sed -i 's/# samples/# of 12 kHz/; s/# depth/# how deep/; s/^\[score\]/\n&\n/' pipeline/protocol.toml
  sed -i 's/# a comment/# another/' pipeline/datasets/real.toml
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_an_option_of_one_method_remakes_that_method() {
  finished_grid
  sed -i 's/^  3,/  4,/' pipeline/protocol.toml
  grid >/dev/null
  expect_no_line "$(<calls)" "smote|none"
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
}

test_an_option_remakes_what_is_like_that_method() {
  describe
  printf '[train.ae]\nlike = "piae-dt"\n' >>pipeline/protocol.toml
  grid METHODS="smote ae" >/dev/null
  rm calls
  sed -i 's/^  3,/  4,/' pipeline/protocol.toml
  grid METHODS="smote ae" >/dev/null
  expect_no_line "$(<calls)" "smote"
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
  expect_equal "$(grep -v '^#' results/t/.settings/train.ae.toml)" $'epochs = 200\nlayers = [ 4 ]'
}

test_an_option_of_all_methods_remakes_them() {
  finished_grid
  sed -i 's/epochs = 200/epochs = 100/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "16 diagnose, 8 generate, 8 score, 2 tabulate, 8 train"
}

test_an_option_of_a_late_stage_remakes_that_stage() {
  finished_grid
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "24 diagnose, 2 tabulate"
  sed -i 's/kernels = 5/kernels = 3/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "8 score, 2 tabulate"
}

test_a_description_remakes_its_data_set() {
  finished_grid
  sed -i 's/"#1"/"#2"/' pipeline/datasets/real.toml
  grid >/dev/null
  expect_no_line "$(<calls)" "made"
  expect_equal "$(ran)" "12 diagnose, 4 generate, 1 ingest, 4 score, 2 split, 1 tabulate, 4 train"
}

test_a_description_that_is_like_another_follows_it() {
  finished_grid
  printf 'name = "other"\nlike = "made"\n' >pipeline/datasets/other.toml
  grid DATASETS=other >/dev/null
  expect_line "$(<calls)" '^simulate other'
  rm calls
  sed -i 's/noise = 0.1/noise = 0.2/' pipeline/datasets/made.toml
  grid DATASETS=other >/dev/null
  expect_equal "$(ran)" "12 diagnose, 4 generate, 4 score, 1 simulate, 2 split, 1 tabulate, 4 train"
}

test_a_data_set_may_have_a_split_of_its_own() {
  describe
  printf '[split]\nwindow = 4096\n' >>pipeline/datasets/real.toml
  grid >/dev/null
  expect_line "$(<results/t/real/seed0/A.h5)" '--config results/t/.settings/split.real.toml '
  expect_line "$(<results/t/made/seed0/A.h5)" '--config results/t/.settings/split.toml '
  expect_equal "$(grep -v '^#' results/t/.settings/split.real.toml)" 'window = 4096'
  rm calls
  sed -i 's/= 4096/= 2048/' pipeline/datasets/real.toml
  sed -i 's/= 1024/= 512/' pipeline/protocol.toml
  grid DATASETS=real >/dev/null
  expect_no_line "$(<calls)" "made"
  expect_equal "$(ran)" "12 diagnose, 4 generate, 1 ingest, 4 score, 2 split, 1 tabulate, 4 train"
}

test_stages_read_the_settings_that_were_compared() {
  finished_grid
  expect_equal "$(grep -v '^#' results/t/.settings/train.smote.toml)" $'epochs = 200\nneighbours = 4'
  expect_equal "$(grep -v '^#' results/t/.settings/train.piae-dt.toml)" $'epochs = 200\nlayers = [ 3 ]'
  expect_equal "$(<results/t/.settings/split.toml)" \
    "$(printf '%s\n' '# Made from pipeline/protocol.toml; edit that file, not this one.' \
      '# Options given by make: --protocol random' 'window = 1024')"
}

test_a_part_leaves_the_tables_of_the_whole() {
  finished_grid
  local part
  for part in SEEDS=0 RATIOS="100to1 1to1" METHODS="none smote" "METHODS=piae-dt none" DATASETS=made; do
    grid "$part" >/dev/null
    expect_equal "$(ran)" ""
  done
}

test_a_part_that_adds_something_shares_what_is_there() {
  finished_grid
  grid SEEDS="0 2" DATASETS=real METHODS="none smote" >/dev/null
  expect_equal "$(ran)" "4 diagnose, 1 generate, 1 score, 1 split, 1 tabulate, 1 train"
  expect_line "$(<results/t/real/accuracy.csv)" "--methods none smote --ratios 100to1 10to1 1to1 --seeds 0 2 --classifiers wdcnn --published"
  grid DATASETS=real >/dev/null
  expect_equal "$(ran)" ""
}

# Cells that were made without tables are in the next ones, whatever these are asked for.
test_tables_have_what_was_made_since() {
  finished_grid
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=vae RATIOS=10to1 SEEDS=0 >/dev/null
  rm calls
  grid SEEDS=1 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  rm -r results/t/real/seed0/vae
  grid SEEDS=1 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_what_was_removed_leaves_the_tables() {
  finished_grid
  rm -r results/t/real/seed1
  grid SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 tabulate"
}

left_out() { # data set
  sed -nE 's/.* --leave-out (.*) --published .*/\1/p' "results/t/$1/accuracy.csv"
}

# Nobody has asked for smote: it is not made again, but the tables do not show the old numbers either.
test_what_is_out_of_date_and_not_asked_for_is_left_out_of_the_tables() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  grid METHODS="none piae-dt" >/dev/null
  expect_equal "$(ran)" "2 tabulate"
  expect_equal "$(left_out real)" "seed0/smote seed1/smote"
  grid METHODS="none piae-dt" >/dev/null
  expect_equal "$(ran)" ""
  grid SEEDS=0 >/dev/null
  expect_equal "$(ran)" "4 diagnose, 2 generate, 2 score, 2 tabulate, 2 train"
  expect_equal "$(left_out made)" "seed1/smote"
  grid METHODS=none RATIOS=100to1 SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(ran)" ""
  grid >/dev/null
  expect_equal "$(ran)" "4 diagnose, 2 generate, 2 score, 2 tabulate, 2 train"
  expect_equal "$(left_out made)" ""
}

test_what_is_out_of_date_is_told_by_the_steps_that_would_make_it() {
  finished_grid
  sed -i 's/kernels = 5/kernels = 3/' pipeline/protocol.toml
  grid METHODS="none smote" DATASETS=real >/dev/null
  expect_equal "$(left_out real)" "seed0/piae-dt/score.h5 seed1/piae-dt/score.h5"
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  grid METHODS=none SEEDS=0 DATASETS=real >/dev/null
  expect_line "$(left_out real)" "^seed0/piae-dt/10to1/diagnosis.h5 seed0/piae-dt/1to1/diagnosis.h5 seed0/piae-dt/score.h5 "
  expect_line "$(left_out real)" " seed1/none/100to1/diagnosis.h5 "
  expect_no_line "$(left_out real)" "seed0/none"
  sed -i 's/"#1"/"#2"/' pipeline/datasets/real.toml
  rm calls
  grid METHODS=none SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split, 1 tabulate"
  expect_equal "$(left_out real)" "seed0 seed1"
}

# With or without the words that the run was made with.
test_looking_at_a_run_changes_nothing_of_it() {
  finished_grid
  local before
  before=$(sha256sum results/t/.settings/*.toml)
  make --silent figures report BIN=fake RUN=t >/dev/null
  make --silent report BIN=fake RUN=t METHODS="none smote" SEEDS=0 DATASETS=real >/dev/null
  expect_equal "$(sha256sum results/t/.settings/*.toml)" "$before"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

# Whoever only looks at a run makes nothing again, but does not look at old numbers among new ones either.
test_what_is_out_of_date_is_left_out_of_figures_and_report() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  rm -f reports
  make --silent figures report BIN=fake RUN=t >/dev/null
  expect_equal "$(ran)" ""
  expect_line "$(<results/t/real/figures.log)" "--leave-out seed0/smote seed1/smote --published"
  expect_line "$(<reports)" "--leave-out $(echo {made,real}/seed{0,1}/smote)"
  rm -r reports results/t/*/seed*/{none,piae-dt} # a run that is old as a whole is of one kind
  make --silent figures report BIN=fake RUN=t >/dev/null
  expect_no_line "$(<reports) $(<results/t/real/figures.log)" "--leave-out"
}

# A part at a ratio that is not asked for, of a method that is.
test_cells_that_are_not_asked_for_go_with_the_model_that_is_made_again() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  grid DATASETS=real RATIOS=10to1 METHODS=smote SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 score, 1 tabulate, 1 train"
  expect_equal "$(left_out real)" "seed0/smote seed1/smote"
  grid DATASETS=real RATIOS=100to1 METHODS=none SEEDS=0 >/dev/null
  expect_equal "$(ran)" ""
  rm results/t/real/tables.md
  grid DATASETS=real RATIOS=100to1 METHODS=none SEEDS=0 >/dev/null
  expect_equal "$(left_out real)" "seed0/smote/1to1/diagnosis.h5 seed1/smote"
}

test_a_table_that_is_a_goal_is_of_all_that_the_run_holds() {
  finished_grid
  rm results/t/real/tables.md
  make --silent BIN=fake RUN=t DATASETS=real METHODS=none RATIOS=100to1 SEEDS=0 results/t/real/tables.md >/dev/null
  expect_equal "$(ran)" "1 tabulate"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

test_blocked_protocol_has_its_own_folder() {
  finished_grid
  grid PROTOCOL=blocked DATASETS=real SEEDS=0 METHODS=none >/dev/null
  expect_equal "$(ran)" "2 diagnose, 1 ingest, 1 split, 1 tabulate"
  expect_line "$(<results/t-blocked/real/seed0/A.h5)" "--protocol blocked"
  grid >/dev/null
  expect_equal "$(ran)" ""
}

# A table stage that looks for its cells, as the real one does.
fussy_tabulate() {
  mkdir fake/lenient
  mv fake/tabulate fake/lenient
  ln -sf ../stage fake/lenient/tabulate
  cat >fake/tabulate <<'STAGE'
#!/bin/bash
[[ -f $2 ]] || { echo "tabulate: $2 was not readable" >&2 && exit 66; }
run=$4/$6 status=0 # --config FILE --run FOLDER --dataset NAME
for file in "$run"/seed{0,1}/{none/100to1/diagnosis,{smote,piae-dt}/{score,10to1/diagnosis,1to1/diagnosis}}.h5; do
  [[ -e $file ]] || { echo "tabulate: $file: missing" >&2 && status=66; }
done
((status)) && exit $status
exec fake/lenient/tabulate "$@"
STAGE
  chmod +x fake/tabulate
}

test_every_hole_is_named_and_the_other_cells_are_made() {
  describe
  fussy_tabulate
  echo "train real/seed1/smote/model.h5" >broken
  local output code=0
  output=$(grid -k -j2 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real/seed1/smote +train: the reason$"
  expect_line "$output" "^real/seed1/smote +train +failed with exit code 65 after .*results/t/real/seed1/smote/train.log"
  expect_equal "$(sed -n 's/^real  *tabulate: \(.*\): missing/\1/p' <<<"$output")" \
    "$(printf 'results/t/real/seed1/smote/%s.h5\n' score 10to1/diagnosis 1to1/diagnosis)"
  expect_no_line "$output" "^made .* missing"
  expect_equal "$(ran)" "22 diagnose, 7 generate, 1 ingest, 7 score, 1 simulate, 4 split, 1 tabulate, 7 train"
  [[ ! -e results/t/real/accuracy.csv ]] || fail "there is a table with holes"
  rm broken
  expect_exit 0 grid
  expect_equal "$(ran)" "2 diagnose, 1 generate, 1 score, 1 tabulate, 1 train"
}

test_the_holes_are_named_also_when_make_stops_at_the_first() {
  describe
  fussy_tabulate
  echo "score real/seed0/smote/score.h5" >broken
  local output code=0
  output=$(grid 2>&1) || code=$?
  expect_equal "$code" 2
  expect_line "$output" "^real +tabulate: results/t/real/seed0/smote/score.h5: missing"
  rm broken
  expect_exit 0 grid
  expect_equal "$(awk '{ print $2 }' calls | grep -c smote)" 22 # none of them twice
}

test_cells_that_could_not_be_made_again_are_holes() {
  finished_grid
  sed -i 's/^neighbours = 4/neighbours = 3/' pipeline/protocol.toml
  echo "train real/seed1/smote/model.h5" >broken
  grid -k >/dev/null 2>&1 || true
  local cell=results/t/real/seed1/smote
  expect_line "$(<results/t/real/accuracy.csv)" \
    " --outdated $cell/10to1/diagnosis.h5 --outdated $cell/1to1/diagnosis.h5 --outdated $cell/score.h5 --config "
  expect_no_line "$(<results/t/made/accuracy.csv)" "outdated"
}

# As a job on a cluster asks for them: its goals are files.
test_a_run_may_be_called_as_a_goal_is() {
  describe
  local run
  for run in sweep mysweep readings; do
    make --silent -f pipeline/grid.mk BIN=fake RUN=$run results=results/$run DATASETS=real METHODS=smote \
      RATIOS=10to1 SEEDS=0 LIBTORCH=off PROTOCOL=random results/$run/real/seed0/smote/10to1/diagnosis.h5 >/dev/null
  done
}

test_a_signal_to_make_all_reaches_the_stage() {
  describe
  rm fake/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ntrap "touch saved; exit 75" TERM\ntouch started\nwhile :; do sleep 0.05; done\n' >fake/train
  chmod +x fake/train
  set -m
  make --silent all BIN=fake DATASETS=real METHODS=piae-dt SEEDS=0 >messages 2>&1 &
  set +m
  wait_for started
  kill -TERM $!
  expect_exit 143 wait $!
  wait_for saved
  expect_no_line "$(<messages)" "not every cell"
}

test_what_is_written_when_make_is_stopped_stays() {
  describe
  rm fake/train
  # shellcheck disable=SC2016
  printf '%s\n' '#!/bin/bash' 'trap "" TERM' 'while (($#)); do [[ $1 != --output ]] || echo made >"$2"; shift; done' \
    'touch written' 'sleep 1' >fake/train
  chmod +x fake/train
  set -m
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=piae-dt SEEDS=0 >messages 2>&1 &
  set +m
  wait_for written
  kill -TERM $!
  expect_exit 143 wait $!
  expect_equal "$(<results/t/real/seed0/piae-dt/model.h5)" made
  expect_no_line "$(<messages)" Deleting
}

test_a_lost_window_file_brings_back_its_split() {
  finished_grid
  rm results/t/real/seed0/D.h5
  grid >/dev/null
  expect_equal "$(ran)" "6 diagnose, 2 generate, 2 score, 1 split, 1 tabulate, 2 train"
}

test_unknown_names_are_refused() {
  describe
  expect_line "$(grid DATASETS=nowhere 2>&1 || true)" "DATASETS: unknown 'nowhere'; there are: made real"
  expect_line "$(grid RATIOS=3to1 2>&1 || true)" "RATIOS: unknown '3to1'"
  expect_line "$(grid METHODS=none RATIOS=1to1 2>&1 || true)" "no cells"
  expect_line "$(grid METHODS=magic 2>&1 || true)" "METHODS: unknown 'magic'; there are: none dynamics smote "
  expect_line "$(grid CLASSIFIERS=svm 2>&1 || true)" "CLASSIFIERS: unknown 'svm'; there are: wdcnn wdcnn-spectrum .* nearest"
  expect_line "$(grid CLASSIFIERS='nearest nearest' 2>&1 || true)" "CLASSIFIERS: 'nearest nearest' names one twice"
  expect_line "$(grid SEEDS='0 x' 2>&1 || true)" "SEEDS: whole numbers"
  expect_line "$(grid SEEDS='1 1' 2>&1 || true)" "names one twice"
  expect_line "$(grid SEEDS= 2>&1 || true)" "SEEDS: is empty"
  expect_line "$(grid RUN=../t 2>&1 || true)" "not a path"
  for sign in ':' '=' '%' ','; do
    expect_line "$(grid RUN="a${sign}b" 2>&1 || true)" "RUN: holds a $sign, which it must not"
  done
  expect_line "$(grid METHODS='smote smote' 2>&1 || true)" "METHODS: 'smote smote' names one twice"
  expect_line "$(grid RUN=reference 2>&1 || true)" "RUN: 'reference' cannot be the name of a run"
  expect_line "$(grid PROTOCOL='random blocked' 2>&1 || true)" "PROTOCOL: random or blocked, not 'random blocked'"
  expect_exit 2 grid PROTOCOL=other
  expect_equal "$(ls)" "$(printf '%s\n' Makefile fake jobs pipeline results)"
}

# Else a stage would run with what its program has built in.
test_a_table_of_the_protocol_that_nothing_reads_is_refused() {
  describe
  echo '[diagnoze]' >>pipeline/protocol.toml
  expect_line "$(grid 2>&1 || true)" "^settings: pipeline/protocol.toml, line 18: nothing reads the table \[diagnoze\]"
  sed -i 's/^\[diagnoze\]/[diagnose/' pipeline/protocol.toml
  expect_line "$(grid 2>&1 || true)" "^settings: pipeline/protocol.toml, line 18: not valid TOML"
  [[ ! -e calls ]] || fail "ran: $(<calls)"
}

test_a_single_artefact_is_a_goal() {
  describe
  make --silent BIN=fake RUN=t DATASETS=real results/t/real/seed3/piae-dt/model.h5 >/dev/null
  expect_equal "$(ran)" "1 ingest, 1 split, 1 train"
}

test_demo_is_a_small_grid_of_its_own() {
  describe
  mv pipeline/datasets/made.toml pipeline/datasets/simulated-small.toml
  local output
  output=$(make --silent demo BIN=fake 2>&1)
  expect_equal "$(ran)" "12 diagnose, 8 generate, 6 score, 1 simulate, 2 split, 1 tabulate, 8 train"
  expect_line "$(tail -n 1 <<<"$output")" "results/demo/simulated-small/"
}

test_the_papers_methods_those_recommended_and_all_ratios_run_where_none_are_given() {
  describe
  make --silent all BIN=fake RUN=t DATASETS=real SEEDS=0 >/dev/null
  expect_line "$(<results/t/real/accuracy.csv)" \
    "--methods none dynamics smote vae wgan-gp piae-dt ae physics piae-dt-cnn piae-dt-rnn piae-dt-phase shift --ratios 100to1 50to1 25to1 10to1 5to1 2to1 1to1 --seeds 0 "
}

test_a_lost_table_comes_back() {
  finished_grid
  local table
  for table in accuracy.csv gains.csv quality.csv comparisons.csv ranks.csv decisions.csv confidence.csv recommendation.csv tables.md tables.tex summary.txt; do
    rm results/t/real/$table
    grid >/dev/null
    expect_equal "$(ran)" "1 tabulate"
    [[ -e results/t/real/$table ]] || fail "$table did not come back"
  done
}

# As a make at the same time leaves them. An empty --leave-out would swallow the next option.
test_seeds_that_are_only_begun_are_nothing_to_the_tables() {
  finished_grid
  mkdir results/t/real/seed{7,8}
  rm results/t/real/accuracy.csv
  grid DATASETS=real SEEDS=0 >/dev/null
  expect_line "$(<results/t/real/accuracy.csv)" "--seeds 0 --classifiers wdcnn --published"
}

test_a_dry_run_and_a_question_write_nothing() {
  describe
  grid -n >/dev/null
  grid -n cells results/t/real/records.h5 >/dev/null
  expect_exit 1 grid -q
  [[ ! -e results/t ]] || fail "there is $(find results/t)"
  finished_grid
  sed -i 's/epochs = 50/epochs = 60/' pipeline/protocol.toml
  find results -printf '%p %T@ %s\n' >before
  grid -n >/dev/null
  grid -n SEEDS=0 METHODS="none smote" >/dev/null
  expect_exit 1 make --silent -q cells BIN=fake RUN=t DATASETS=real METHODS=smote SEEDS=0
  expect_equal "$(find results -printf '%p %T@ %s\n')" "$(<before)"
  sed -i 's/epochs = 60/epochs = 50/' pipeline/protocol.toml
  expect_exit 0 make --silent -q cells BIN=fake RUN=t DATASETS=real METHODS=smote RATIOS=10to1 SEEDS=0
}

test_cells_write_no_settings_of_tables() {
  describe
  make --silent cells BIN=fake RUN=t DATASETS=real METHODS=smote SEEDS=0 >/dev/null
  expect_equal "$(cd results/t/.settings && find . -type f | sort | xargs)" \
    "./datasets/real.toml ./diagnose.toml ./generate.toml ./score.toml ./split.toml ./train.smote.toml"
}

# The settings files of a run may be older than the programs: whole tables, as they stood.
test_settings_of_the_same_values_in_other_words_change_nothing() {
  finished_grid
  local header="# Made from pipeline/protocol.toml; edit that file, not this one."
  printf '%s\n' "$header" '[train]' 'epochs = 200' '[train.smote]' 'neighbours = 4' \
    >results/t/.settings/train.smote.toml
  printf '%s\n' "$header" '# Options given by make: --protocol random' '[split]' 'window = 1024' \
    >results/t/.settings/split.toml
  touch -d '1 hour ago' results/t/.settings/{train.smote,split}.toml
  grid >/dev/null
  expect_equal "$(ran)" ""
  sed -i 's/neighbours = 4/neighbours = 5/' pipeline/protocol.toml
  grid >/dev/null
  expect_equal "$(ran)" "8 diagnose, 4 generate, 4 score, 2 tabulate, 4 train"
}

test_several_goals_go_to_one_make() {
  describe
  make --silent -j2 records cells results/t/real/seed0/A.h5 BIN=fake RUN=t DATASETS=real METHODS=smote \
    RATIOS=10to1 SEEDS=0 >/dev/null
  expect_equal "$(ran)" "1 diagnose, 1 generate, 1 ingest, 1 score, 1 split, 1 train"
}

test_unknown_variables_are_refused_with_the_right_name() {
  describe
  local pair
  for pair in SEED:SEEDS seeds:SEEDS METHOD:METHODS DATASET:DATASETS Ratio:RATIOS PROTOCOLS:PROTOCOL; do
    expect_line "$(make cells BIN=fake RUN=t "${pair%:*}=x" 2>&1 || true)" \
      "there is no variable ${pair%:*}; did you mean ${pair#*:}\?"
  done
  expect_line "$(make cells BIN=fake RUN=t THREADS=2 2>&1 || true)" "there is no variable THREADS; .make help. lists"
  expect_exit 2 make cells BIN=fake RUN=t SEED=0
  expect_exit 2 make help SEED=0
  [[ ! -e results/t ]] || fail "something ran"
}

test_programs_that_are_not_there_are_one_line() {
  describe
  local goal
  for goal in cells check status data demo; do
    expect_equal "$(make --silent $goal BIN=/nowhere 2>&1 | sed 's/^Makefile:[0-9]*: //')" \
      "*** BIN: there are no programs in '/nowhere'; \`make build\` builds them into build/bin.  Stop."
  done
  rm -r fake
  expect_line "$(make -n cells 2>&1 || true)" "the programs must be built first: .make build."
  expect_exit 0 make -n cells
}

# Programs of before do not know what the sources and pipeline/ have learned since.
test_a_dry_run_with_programs_of_before_says_that_they_would_be_built() {
  describe
  mkdir -p build/bin src
  printf '#!/bin/bash\necho "settings: nothing reads the table [train.new]" >&2\nexit 65\n' >build/bin/settings
  chmod +x build/bin/settings
  touch -d '1 hour ago' build/bin/settings
  touch src/new.cpp
  expect_line "$(make -n cells 2>&1)" "the programs must be built first: .make build."
  touch build/bin/settings
  touch -d '1 hour ago' src/new.cpp src
  expect_line "$(make -n cells 2>&1 || true)" "nothing reads the table .train.new."
}

test_libtorch_is_on_or_off() {
  describe
  expect_line "$(grid LIBTORCH=no 2>&1 || true)" "LIBTORCH: on or off, not 'no'"
}

# 10 seeds of 14 cells: nobody wants to read their names.
test_without_recordings_the_data_set_says_so_and_no_cell_does() {
  describe
  fussy_tabulate
  echo "ingest real/records.h5" >broken
  local output code=0
  output=$(grid -k SEEDS="0 1 2 3 4 5 6 7 8 9" 2>&1) || code=$?
  expect_equal "$code" 2
  expect_equal "$(grep -c '^real .*the reason' <<<"$output")" 1
  expect_no_line "$output" "missing"
  expect_equal "$(grep -vc '^made' <<<"$output")" 9 # two of the step, the others make's own
  expect_equal "$(ran)" "60 diagnose, 20 generate, 20 score, 1 simulate, 10 split, 1 tabulate, 20 train"
}

run_tests
