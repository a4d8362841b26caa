#!/bin/bash
# Figures of a run: drawn from the numbers that the stage `figures` writes, again when these or the style
# change, and the same bytes each time.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

drawn=results/t/made/figures

# Numbers of one figure, as the stage writes them; the stand-in for it writes what `numbers` says.
lay_out() {
  skip_where_nothing_draws
  rm -f pipeline/datasets/*
  printf 'name = "made"\n[simulation]\n' >pipeline/datasets/made.toml
  cp "$project/tests/reference/protocol.toml" pipeline
  mkdir -p results/published $drawn
  cat >fake/figures <<'STAGE'
#!/bin/bash
mkdir -p results/t/made/figures
[[ ! -d numbers ]] || for csv in numbers/*; do
  cmp -s "$csv" "results/t/made/figures/${csv##*/}" || cp "$csv" results/t/made/figures
  echo "wrote ${csv##*/}"
done
echo "wrote the numbers of some figures"
STAGE
  chmod +x fake/figures
  mkdir -p numbers results/t/made/seed0
  touch results/t/made/seed0/C.h5
  losses 3 >numbers/fig07-losses.csv
}

losses() { # of the last epoch
  printf '%s\n' seed,stage,epoch,curve,value 0,1,1,twin,9 0,2,2,twin,5 "0,1,3,twin,$1" \
    mean,1,1,twin,9 mean,2,2,twin,5 "mean,1,3,twin,$1"
}

# A cell is made again, and with it other numbers.
new_cell() { touch -d 'now + 1 second' results/t/made/seed0/C.h5; }
figures() { make --silent figures BIN=fake RUN=t DATASETS=made METHODS="none piae-dt" RATIOS="100to1 10to1" SEEDS=0; }
pictures() { sha256sum $drawn/*.svg $drawn/*.pdf; }

test_each_figure_is_an_svg_and_a_pdf_beside_its_numbers() {
  lay_out
  figures >messages 2>&1 || fail "$(<messages)"
  expect_line "$(head -c 300 $drawn/fig07-losses.svg)" '<svg'
  expect_equal "$(head -c 5 $drawn/fig07-losses.pdf)" "%PDF-"
  expect_line "$(tail -n 1 messages)" "^figures: $drawn/$"
}

# The stand-in for the stage writes down what it was asked.
asked_of_figures() { sed -n 's/.*--run results\/t --dataset made *//p' results/t/made/figures.log; }

test_what_is_only_looked_at_need_not_be_there() {
  lay_out
  make --silent figures BIN=fake RUN=t >/dev/null 2>&1
  expect_equal "$(asked_of_figures)" "--published results/published"
  make --silent figures BIN=fake RUN=t SEEDS="0 1" >/dev/null 2>&1
  expect_equal "$(asked_of_figures)" "--seeds 0 1 --published results/published"
}

test_a_report_is_of_what_the_run_holds_unless_more_is_asked_for() {
  lay_out
  make --silent report BIN=fake RUN=t
  make --silent report BIN=fake RUN=t METHODS="none vae"
  expect_equal "$(tr -s " " <reports | sed "s/ $//")" "$(printf '%s\n' 'report: --run results/t --published results/published' \
    'report: --run results/t --methods none vae --published results/published')"
}

test_the_same_numbers_give_the_same_bytes() {
  lay_out
  figures >/dev/null 2>&1
  local first
  first=$(pictures)
  rm $drawn/*.svg $drawn/*.pdf
  sleep 1.1 # a PDF would hold the second at which it was drawn
  figures >/dev/null 2>&1
  expect_equal "$(pictures)" "$first"
}

test_another_time_zone_and_language_give_the_same_bytes() {
  lay_out
  TZ=Asia/Tokyo LC_ALL=C figures >/dev/null 2>&1
  local first
  first=$(pictures)
  rm $drawn/*.svg $drawn/*.pdf
  TZ=America/New_York LC_ALL=C.UTF-8 figures >/dev/null 2>&1
  expect_equal "$(pictures)" "$first"
}

test_only_what_has_new_numbers_is_drawn_again() {
  lay_out
  losses 4 >numbers/fig08-loss-weights.csv
  figures >/dev/null 2>&1
  touch -d '2001-01-01' $drawn/*.svg
  touch -d '2000-01-01' $drawn/*.csv pipeline/figures/*
  losses 2 >numbers/fig07-losses.csv
  new_cell
  figures >/dev/null 2>&1
  [[ $(date -r $drawn/fig07-losses.svg +%Y) != 2001 ]] || fail "the changed one was not drawn again"
  expect_equal "$(date -r $drawn/fig08-loss-weights.svg +%Y)" 2001
}

test_lost_numbers_and_a_lost_folder_come_back() {
  lay_out
  figures >/dev/null 2>&1
  local first
  first=$(pictures)
  rm $drawn/fig07-losses.csv
  figures >/dev/null 2>&1
  expect_equal "$(pictures)" "$first"
  rm -r $drawn
  figures >/dev/null 2>&1
  expect_equal "$(pictures)" "$first"
}

test_without_a_cell_nothing_is_drawn() {
  lay_out
  rm -r results/t/made
  expect_exit 2 figures
  [[ ! -e results/t/made ]] || fail "made $(find results/t/made)"
}

# A sweep, the truth, and the run with the other split are shown as well.
test_what_comes_later_beside_the_cells_makes_new_numbers() {
  lay_out
  figures >/dev/null 2>&1
  local file loss=10
  for file in t/made/seed0/sweep/batch-1/1to1/wdcnn/diagnosis.h5 t/made/seed0/sweep@vae/latent-1/1to1/nearest/diagnosis.h5 \
    t/made/sweep@vae.csv t/made/scatter.csv t-blocked/made/seed0/none/100to1/wdcnn/diagnosis.h5; do
    losses $((++loss)) >numbers/fig07-losses.csv
    figures >/dev/null 2>&1
    grep -q ",$loss$" $drawn/fig07-losses.csv && fail "numbers are made again though there is nothing new"
    mkdir -p "$(dirname "results/$file")"
    touch "results/$file"
    figures >/dev/null 2>&1
    expect_line "$(<$drawn/fig07-losses.csv)" ",$loss$"
  done
}

# Of one seed, of few methods, and with classes that are named by digits.
test_figures_of_a_few_numbers_are_drawn_without_a_word() {
  lay_out
  local sample
  for sample in "$project"/tests/slow/pipeline/figures/*.csv; do
    cp "$sample" $drawn
    expect_equal "$(pipeline/figures/draw.sh "$drawn/${sample##*/}" 2>&1)" ""
    sample=${sample##*/}
    expect_line "$(head -c 300 "$drawn/${sample%.csv}.svg")" '<svg'
  done
}

# Of one seed there is no spread.
test_readings_of_one_seed_are_drawn_without_a_word() {
  lay_out
  sed -E '2,$ { s/,5,([^,]*),.*/,1,\1,/ }' "$project/tests/slow/pipeline/figures/readings.csv" >$drawn/readings.csv
  expect_line "$(<$drawn/readings.csv)" ',1,[^,]+,$'
  expect_no_line "$(<$drawn/readings.csv)" ',5,'
  expect_equal "$(pipeline/figures/draw.sh $drawn/readings.csv 2>&1)" ""
  expect_line "$(head -c 300 $drawn/readings.svg)" '<svg'
}

# Eq. 23: alpha weighs L_DDL, beta L_DT, gamma L_Rec.
test_the_weights_of_fig_8_name_their_losses() {
  lay_out
  printf '%s\n' seed,stage,epoch,curve,value mean,1,1,alpha,1 mean,1,1,beta,2 mean,1,1,gamma,3 >$drawn/fig08-loss-weights.csv
  pipeline/figures/draw.sh $drawn/fig08-loss-weights.csv
  expect_line "$(<$drawn/fig08-loss-weights.svg)" '>α, differential<'
  expect_line "$(<$drawn/fig08-loss-weights.svg)" '>β, twin<'
  expect_line "$(<$drawn/fig08-loss-weights.svg)" '>γ, reconstruction<'
}

# What others of the paper's recordings stand in for is named; a gain has a line at zero, an accuracy none.
test_published_values_name_their_recordings() {
  lay_out
  {
    echo method,ceiling,ratio,generated_per_class,seed,gain,low,high,published,published_of
    echo vae,0,10to1,45,0,3,,,,
    echo vae,0,10to1,45,mean,3,,,20,HFHP
  } >$drawn/fig15-gains.csv
  # With 2 percent zero is near the axis, where a line at it would be seen.
  sed 's/gain,/accuracy,/; s/,3,/,63,/; s/,20,/,2,/' $drawn/fig15-gains.csv >$drawn/accuracies.csv
  local name
  for name in fig15-gains accuracies; do
    expect_equal "$(pipeline/figures/draw.sh $drawn/$name.csv 2>&1)" ""
    expect_line "$(<$drawn/$name.svg)" '>as published of HFHP<'
  done
  expect_line "$(<$drawn/fig15-gains.svg)" "stroke='rgb\( 51,  51,  51\)'"
  expect_no_line "$(<$drawn/accuracies.svg)" "stroke='rgb\( 51,  51,  51\)'"

  # The name of the run says nothing of what is drawn.
  mkdir -p results/gains
  cp $drawn/accuracies.csv results/gains
  pipeline/figures/draw.sh results/gains/accuracies.csv
  cmp $drawn/accuracies.svg results/gains/accuracies.svg
}

# Methods of which each has but some of the ratios.
test_ratios_stand_in_the_order_of_their_generated_windows() {
  lay_out
  {
    echo method,ceiling,ratio,generated_per_class,seed,accuracy,low,high,published,published_of
    printf '%s,mean,60,,,,\n' none,0,100to1,0 smote,0,1to1,495 vae,0,10to1,45 vae,0,2to1,145
  } >$drawn/accuracies.csv
  pipeline/figures/draw.sh $drawn/accuracies.csv
  expect_equal "$(grep -oE '[0-9]+:1\b' $drawn/accuracies.svg | paste -sd' ')" "100:1 10:1 2:1 1:1"
}

test_the_script_that_contributing_shows_draws() {
  lay_out
  "$project/tests/slow/contributing/lay_out.sh" "$project" shown
  cp shown/pipeline/figures/seed-range.gp pipeline/figures
  printf '%s\n' method,ratio,low,high none,100to1,55,66 vae,10to1,30,42 vae,1to1,20,25 >$drawn/seed-range.csv
  expect_equal "$(pipeline/figures/draw.sh $drawn/seed-range.csv 2>&1)" ""
  expect_line "$(<$drawn/seed-range.svg)" '10to1'
}

test_a_changed_style_draws_all_again() {
  lay_out
  figures >/dev/null 2>&1
  local first
  first=$(pictures)
  sed -i 's/0x0072B2/0x123456/' pipeline/figures/style.gp
  figures >/dev/null 2>&1
  [[ $(pictures) != "$first" ]] || fail "the pictures are as before"
}

test_nothing_is_drawn_through_a_planted_link() {
  lay_out
  mkdir elsewhere
  ln -s "$PWD/elsewhere" $drawn/fig07-losses.svg
  ln -s "$PWD/elsewhere" $drawn/fig07-losses.pdf
  figures >messages 2>&1 || fail "$(<messages)"
  expect_equal "$(ls elsewhere)" ""
  expect_line "$(head -c 300 $drawn/fig07-losses.svg)" '<svg'
}

test_a_picture_without_numbers_is_removed() {
  lay_out
  figures >/dev/null 2>&1
  rm $drawn/fig07-losses.csv numbers/fig07-losses.csv
  losses 4 >numbers/fig08-loss-weights.csv
  new_cell
  figures >/dev/null 2>&1
  expect_equal "$(find $drawn -type f -printf '%f\n' | sort | paste -sd' ')" "fig08-loss-weights.csv fig08-loss-weights.pdf fig08-loss-weights.svg"
}

test_a_script_that_fails_leaves_no_picture_and_is_named() {
  lay_out
  echo 'plot nothing_that_exists' >>pipeline/figures/fig07-losses.gp
  expect_exit 2 figures
  expect_line "$(figures 2>&1)" 'fig07-losses.gp.*undefined'
  expect_equal "$(find $drawn -mindepth 1 -printf '%f\n')" fig07-losses.csv
}

run_tests "$@"
