#!/bin/bash
# The regression check on a tiny grid, with the built programs: numbers must still be those of tests/reference. They
# must be equal on the same processor and libraries, and within their spread elsewhere.
#
# After an intended change of numbers:
#   PIAE_BIN=build/bin tests/pipeline/reference_test.sh store
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

grid=$(mktemp -d)
trap 'rm -r "$grid"' EXIT

# Makes a folder with only the front door.
lay_out() {
  rm -r pipeline/datasets
  mkdir -p pipeline/datasets
  cp "$project/tests/reference/tiny.toml" pipeline/datasets
  cp "$project/tests/reference/protocol.toml" pipeline
}
tiny() {
  make --silent "$@" "BIN=$programs" RUN=tiny
}

# Makes the grid once, for the first test that needs it.
made() {
  lay_out
  if [[ ! -d $grid/tiny ]]; then
    tiny all DATASETS=tiny METHODS="none smote piae-dt" RATIOS="100to1 50to1 10to1" SEEDS="0 1" \
      -j"$(nproc)" >messages 2>&1 || fail "$(<messages)"
    cp -r results/tiny "$grid"
  fi
  cp -r "$grid/tiny" results
  mkdir -p results/reference
  cp -r "$project/tests/reference/random" results/reference
}

reference=results/reference/random/tiny.csv
# Adds a number to values of the reference: pattern of the lines, summand.
move() {
  awk -F, -v OFS=, -v pattern="$1" -v by="$2" '$0 ~ pattern { $6 += by } { print }' $reference >moved
  mv moved $reference
}
# Makes the reference look as if it came from another machine.
from_elsewhere() { sed -i 's/^# computed with: .*/# computed with: another machine/' $reference; }

test_numbers_are_as_stored() {
  made
  tiny check >messages 2>&1 || fail "not the numbers of tests/reference/random/tiny.csv: $(<messages)"
  from_elsewhere
  tiny check >messages || fail "$(<messages)"
}

test_tables_and_figures_are_kept_with_the_reference() {
  made
  mkdir -p results/reference/random/tiny/figures
  touch results/reference/random/tiny/figures/of-an-older-run.svg
  tiny reference >messages
  expect_line "$(<messages)" '^kept results/reference/random/tiny/tables.md$'
  cmp results/tiny/tiny/tables.md results/reference/random/tiny/tables.md
  expect_equal "$(ls results/reference/random/tiny/figures)" \
    "$(cd results/tiny/tiny/figures && printf '%s\n' *.csv *.svg | LC_ALL=C sort)"
  expect_line "$(ls results/reference/random/tiny/figures)" '^fig15-gains.svg$'
  expect_line "$(<results/reference/SHA256SUMS)" "  random/tiny/tables.md$"
  expect_exit 0 tiny check
}

test_the_sums_of_the_stored_results_agree() {
  cd "$project/results/reference"
  sha256sum --check --quiet SHA256SUMS
  expect_equal "$(sed 's/^[^ ]*  //' SHA256SUMS)" \
    "$(find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort)"
}

# While a version is in the making, parts may be of several commits. A released one has all of one.
test_the_stored_results_are_of_one_commit() {
  local unreleased=
  grep -m 1 '^## ' "$project/CHANGELOG.md" | grep -q 'not released yet' && unreleased=yes
  cd "$project/results/reference"
  local commit part file built last=
  commit=$(tail -n 1 parts.csv | cut -d, -f2)
  # Compare it with that of the present programs, if the history is there (a tarball may lie in another repository).
  if [[ $(git rev-parse --show-prefix --is-shallow-repository 2>/dev/null | xargs) == "results/reference/ false" ]]; then
    last=$(cd ../.. && decisive_commit HEAD)
    [[ ! $unreleased || $commit == "$last" ]] || skip "because no part is computed by $last yet"
    expect_equal "$commit" "$last"
  fi
  for part in $(sed -n '/^parts=(/,/)$/p' ../../pipeline/reference_all.sh | sed 's/^parts=//' | tr -d '()'); do
    grep -q "^$part,$commit," parts.csv && continue
    [[ ! $unreleased ]] || skip "because the part $part is not computed by $commit yet"
    fail "the part $part is not computed by $commit"
  done
  [[ $last ]] || return 0
  # Programs may be of a later commit, which decides nothing.
  while read -r file built; do
    expect_equal "$file: $(cd ../.. && decisive_commit "$built" 2>&1)" "$file: $last"
  done < <(grep -r '^# built from: ' --include='*.csv' . | grep -v '^\./before/' | sed 's/:#.*(/ /; s/)$//')
}

test_finds_a_changed_digit_on_the_same_machine() {
  made
  tiny reference >/dev/null
  expect_exit 0 tiny check
  move '^smote,,,mmd,1,' 1e-12
  expect_exit 2 tiny check
  expect_line "$(tiny check 2>&1 || true)" '^smote +score +mmd +OUTSIDE +2 +1 '
  expect_exit 0 tiny check TOLERANCE=spread
}

test_finds_deviations_beyond_chance_on_any_machine() {
  made
  tiny reference >/dev/null
  from_elsewhere
  move '^smote,wdcnn,10to1,accuracy,' 0.01
  expect_line "$(tiny check)" '^smote +10to1 +accuracy +2 +2 .* -0\.0[0-9]+ +[0-9.]+$'
  move '^none,wdcnn,100to1,accuracy,' -0.9
  expect_exit 2 tiny check
  expect_line "$(tiny check 2>&1 || true)" '^none +100to1 +accuracy +OUTSIDE +2 +2 '
  expect_line "$(tiny check 2>&1 || true)" '^compared 20 quantities of tiny: 2 moved, 1 outside'
}

test_names_cells_of_only_one_side() {
  made
  rm results/tiny/tiny/seed1/smote/10to1/wdcnn/diagnosis.h5
  sed -i '/^piae-dt,,,.*,0,/d' $reference
  local output
  output=$(tiny check 2>&1 || true)
  expect_line "$output" '^missing in the run: smote 10to1, seed 1$'
  expect_line "$output" '^not in the reference: piae-dt score, seed 0$'
  sed -i '/^none,nearest,/d' $reference
  expect_line "$(tiny check 2>&1 || true)" '^not in the reference: none 100to1 by nearest, seeds 0 1$'
  expect_exit 2 tiny check
  tiny check SEEDS=0 METHODS="none smote" CLASSIFIERS=wdcnn >messages || fail "$(<messages)"
  tiny check RATIOS="100to1 50to1" SEEDS=1 CLASSIFIERS=wdcnn >messages || fail "$(<messages)"
}

test_fails_without_a_reference() {
  made
  rm $reference
  expect_exit 2 tiny check
  expect_line "$(tiny check 2>&1 || true)" '^check: results/reference/random/tiny.csv: there is no reference for tiny; store one from a good run with `make reference'
  tiny reference >/dev/null
  expect_exit 0 tiny check
  tiny reference SEEDS=0 >/dev/null
  expect_line "$(tiny check 2>&1 || true)" '^not in the reference: none 100to1, seed 1$'
}

test_fails_if_the_run_lacks_a_data_set() {
  made
  sed '2,$s/^#\(.*\)/#\1/' $reference >results/reference/random/other.csv
  expect_exit 2 tiny check
  expect_line "$(tiny check 2>&1 || true)" '^missing in the run: smote score, seeds 0 1$'
  expect_exit 0 tiny check DATASETS=tiny
}

store() {
  mkdir "$grid/here"
  enter "$grid/here"
  # Runs it as a named test, because failures are reported with their line in a test.
  test_store() { made && tiny reference && cp $reference "$project/tests/reference/random"; }
  test_store
}

if [[ ${1:-} == store ]]; then store; else run_tests "$@"; fi
