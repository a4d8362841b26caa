#!/bin/bash
# Figures of a run: drawn from the numbers of the stage `figures`, redrawn when the contents of numbers or scripts
# change, with the same bytes each time. tests/plan tests why a step is due, in process.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

drawn=results/t/made/figures

# Writes numbers of one figure, as the stage would; the stand-in for the stage writes the contents of `numbers`.
lay_out() {
  skip_where_nothing_draws
  rm -f pipeline/datasets/*
  printf 'name = "made"\n[simulation]\n' >pipeline/datasets/made.toml
  cp "$project/tests/reference/protocol.toml" pipeline
  cat >fake/figures <<'STAGE'
#!/bin/bash
mkdir -p results/t/made/figures
[[ ! -d numbers ]] || for csv in numbers/*; do
  cmp -s "$csv" "results/t/made/figures/${csv##*/}" || cp "$csv" results/t/made/figures
done
echo "wrote the numbers of some figures"
STAGE
  mkdir -p numbers $drawn results/t/made/seed0
  cell 1
  losses 3 >numbers/fig07-losses.csv
}

losses() { # of the last epoch
  printf '%s\n' seed,stage,epoch,curve,value 0,1,1,twin,9 0,2,2,twin,5 "0,1,3,twin,$1" \
    mean,1,1,twin,9 mean,2,2,twin,5 "mean,1,3,twin,$1"
}

# Makes other windows, and therefore other numbers.
cell() { fake/split --output-dir results/t/made/seed0 --window "$1" >/dev/null; }
figures() { make --silent figures BIN=fake RUN=t DATASETS=made METHODS="none piae-dt" RATIOS="100to1 10to1" SEEDS=0; }
pictures() { sha256sum $drawn/*.svg $drawn/*.pdf; }

test_each_figure_is_an_svg_and_a_pdf_next_to_its_numbers() {
  lay_out
  figures >messages 2>&1 || fail "$(<messages)"
  expect_line "$(head -c 300 $drawn/fig07-losses.svg)" '<svg'
  expect_equal "$(head -c 5 $drawn/fig07-losses.pdf)" "%PDF-"
  expect_line "$(tail -n 1 messages)" "^figures: $drawn/$"
}

test_only_named_cells_must_exist() {
  lay_out
  cell one
  local which
  for which in V= SEEDS="1 0" METHODS="none vae"; do
    make --silent figures report BIN=fake RUN=t "$which" >/dev/null 2>&1
    sed -n 's/^fake.figures *\(.*\)--run results.t --dataset made .*/\1/p' results/t/made/figures.log >>asked
  done
  sed -i 's/ *--published results.published//; s/--costs jobs.costs.csv *//; s/ $//' asked reports
  expect_equal "$(<asked)" $'\n--seeds 1 0\n--methods none vae'
  expect_equal "$(sed 's/^report: --run results.t *//' reports)" "$(<asked)"
}

test_the_same_numbers_give_the_same_bytes_at_any_time_in_any_language() {
  lay_out
  TZ=Asia/Tokyo LC_ALL=C figures >/dev/null 2>&1
  local first
  first=$(pictures)
  rm $drawn/*.svg $drawn/*.pdf
  sleep 1.1 # a PDF would record the second of drawing
  TZ=America/New_York LC_ALL=C.UTF-8 figures >/dev/null 2>&1
  expect_equal "$(pictures)" "$first"
}

test_only_changed_numbers_are_redrawn() {
  lay_out
  losses 4 >numbers/fig08-loss-weights.csv
  figures >/dev/null 2>&1
  drawn_again() { find $drawn -name '*.svg' -newermt 2001-01-02 -printf '%f\n' | sort | xargs; }
  losses 2 >numbers/fig07-losses.csv
  touch -d 2001-01-01 $drawn/*.svg
  touch results/t/made/seed0/* $drawn/*.csv pipeline/figures/*
  figures >/dev/null 2>&1
  expect_equal "$(drawn_again)" ""
  cell 2
  figures >/dev/null 2>&1
  expect_equal "$(drawn_again)" fig07-losses.svg
  sed -i 's/0x0072B2/0x123456/' pipeline/figures/style.gp
  figures >/dev/null 2>&1
  expect_equal "$(drawn_again)" "fig07-losses.svg fig08-loss-weights.svg"
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
  expect_line "$(figures 2>&1 || true)" 'results/t holds no cell of made'
  [[ ! -e results/t/made ]] || fail "made $(find results/t/made)"
}

# Shows a sweep, the truth, and the run with the other split, too.
test_later_cells_make_new_numbers() {
  lay_out
  figures >/dev/null 2>&1
  local file loss=10
  for file in t/made/seed0/sweep/batch-1/1to1/wdcnn/diagnosis.h5 t/made/sweep@vae.csv \
    t/made/seed0/sweep@vae/latent-1/1to1/nearest/diagnosis.h5 t/made/scatter.csv \
    t-blocked/made/seed0/none/100to1/wdcnn/diagnosis.h5; do
    losses $((++loss)) >numbers/fig07-losses.csv
    mkdir -p "$(dirname "results/$file")"
    cp results/t/made/seed0/C.h5 "results/$file"
    figures >/dev/null 2>&1
    expect_line "$(<$drawn/fig07-losses.csv)" ",$loss$"
  done
}

# Draws a single seed, few methods, and classes with digits as names.
test_figures_of_a_few_numbers_are_drawn_without_warnings() {
  lay_out
  local sample
  for sample in "$project"/tests/slow/pipeline/figures/*.csv; do
    cp "$sample" $drawn
    expect_equal "$(pipeline/figures/draw.sh "$drawn/${sample##*/}" 2>&1)" ""
    sample=${sample##*/}
    expect_line "$(head -c 300 "$drawn/${sample%.csv}.svg")" '<svg'
  done
}

# Prints the texts of a picture that lie within its width.
texts_inside() { # picture
  tr '\n' ' ' <"$1" | sed 's/<g transform="translate(/\n/g' |
    sed -nE 's/^([0-9.]+),[0-9.]+[^>]*>[[:space:]]*<text>(.*)<\/text>.*/\1 \2/p' |
    sed -E 's/<[^>]+>//g' | awk '$1 > 0 && $1 < 960 { sub(/^[^ ]+ */, ""); print }'
}

test_the_legend_names_every_method() {
  lay_out
  local sample=$project/tests/slow/pipeline/figures/transfer@sizes.csv i
  { # many methods
    cat "$sample"
    for i in {1..20}; do sed -n "/,none,method,/s/,none,/,rival-$i,/p" "$sample"; done
  } >"$drawn/transfer@many.csv"
  pipeline/figures/draw.sh "$drawn/transfer@many.csv"
  texts_inside "$drawn/transfer@many.svg" >texts
  for i in {1..20}; do expect_line "$(<texts)" "^rival-$i, wdcnn-spectra *$"; done
  expect_line "$(<texts)" '^strike-twin, wdcnn-spectra *$'
  expect_line "$(<texts)" '^none by nearest *$'

  # A run with other classifiers than the recorded ones.
  sed 's/,1,1,1to1,/,0,0,1to1,/' "$sample" >"$drawn/transfer@others.csv"
  pipeline/figures/draw.sh "$drawn/transfer@others.csv"
  texts_inside "$drawn/transfer@others.svg" >texts
  for i in none strike-twin; do
    expect_line "$(<texts)" "^$i, wdcnn *$"
    expect_line "$(<texts)" "^$i, wdcnn-spectra *$"
  done
}

# A panel for each group whose speed changes.
test_tables_of_several_groups_are_joined() {
  lay_out
  local samples=$project/tests/slow/pipeline/figures
  sed 's/,0\.5000,/,0.8000,/' "$samples/transfer@speeds.csv" >$drawn/transfer@other.csv
  expect_equal "$(pipeline/figures/draw.sh $drawn/rigs.csv "$samples"/transfer@{sizes,speeds}.csv $drawn/transfer@other.csv 2>&1)" ""
  expect_equal "$(cut -d, -f1 $drawn/rigs.csv | uniq | paste -sd' ')" "part sizes speeds other"
  local group
  for group in HIT-SM other; do expect_line "$(<$drawn/rigs.svg)" ">$group<"; done
  expect_no_line "$(<$drawn/rigs.svg)" '>sizes<'
}

# A single seed does not have a spread.
test_readings_of_one_seed_are_drawn_without_warnings() {
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

# Names recordings that stand in for the paper's; a gain has a line at zero, an accuracy does not.
test_published_values_name_their_recordings() {
  lay_out
  {
    echo method,ceiling,ratio,generated_per_class,seed,gain,low,high,published,published_of
    echo vae,0,10to1,45,0,3,,,,
    echo vae,0,10to1,45,mean,3,,,20,HFHP
  } >$drawn/fig15-gains.csv
  # With 2 percent, zero is near the axis, where a line would be visible.
  sed 's/gain,/accuracy,/; s/,3,/,63,/; s/,20,/,2,/' $drawn/fig15-gains.csv >$drawn/accuracies.csv
  local name
  for name in fig15-gains accuracies; do
    expect_equal "$(pipeline/figures/draw.sh $drawn/$name.csv 2>&1)" ""
    expect_line "$(<$drawn/$name.svg)" '>as published of HFHP<'
  done
  expect_line "$(<$drawn/fig15-gains.svg)" "stroke='rgb\( 51,  51,  51\)'"
  expect_no_line "$(<$drawn/accuracies.svg)" "stroke='rgb\( 51,  51,  51\)'"

  # The name of the run does not affect the figures.
  mkdir -p results/gains
  cp $drawn/accuracies.csv results/gains
  pipeline/figures/draw.sh results/gains/accuracies.csv
  cmp $drawn/accuracies.svg results/gains/accuracies.svg
}

# Methods that have only some of the ratios.
test_ratios_are_ordered_by_their_generated_windows() {
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

test_nothing_is_drawn_through_a_planted_link() {
  lay_out
  mkdir elsewhere
  ln -s "$PWD/elsewhere" $drawn/fig07-losses.svg
  ln -s "$PWD/elsewhere" $drawn/fig07-losses.pdf
  figures >messages 2>&1 || fail "$(<messages)"
  expect_equal "$(ls elsewhere)" ""
  expect_line "$(head -c 300 $drawn/fig07-losses.svg)" '<svg'
}

test_a_failing_script_is_named_and_does_not_block_others() {
  lay_out
  losses 4 >numbers/fig08-loss-weights.csv
  echo 'plot nothing_that_exists' >>pipeline/figures/fig07-losses.gp
  expect_exit 2 figures
  expect_line "$(figures 2>&1)" 'fig07-losses.gp.*undefined'
  expect_equal "$(find $drawn -mindepth 1 -printf '%f\n' | sort | xargs)" \
    "fig07-losses.csv fig08-loss-weights.csv fig08-loss-weights.pdf fig08-loss-weights.svg"
}

run_tests "$@"
