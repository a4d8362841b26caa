#!/bin/bash
# `make reference-all`: which parts are due, and that every request of a part is a valid one.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

list=results/reference/parts.csv

# Makes the folder a repository, and a make that notes its request, fails for the one in the file `broken`, and stores three
# figures and tables. After a run of readings it leaves their table alone, as the real one does.
lay_out() {
  mkdir -p src stages results/reference
  touch CMakeLists.txt src/code stages/code
  git -c init.defaultBranch=main init --quiet
  commit
  cat >remake <<'MAKE'
#!/bin/bash
echo "$*" >>requests
[[ ! -e broken ]] || ! grep -qF "$(<broken)" <<<"$*" || exit 1
folder=results/reference/random
for word; do
  [[ $word != REFERENCE=* ]] || folder=${word#*=}/random
  [[ $word != RUN=* ]] || run=results/${word#*=}
done
[[ $1 != readings ]] || { mkdir -p "$run/cwru" && touch "$run/cwru/readings.md"; }
[[ $1 == reference ]] || exit 0
# Refuses such a run, as `check --store` does.
[[ ! -e $run/cwru/readings.md ]] || exit 66
mkdir -p "$folder/cwru/figures"
touch "$folder/transfer@"{sizes,speeds,uestc-speeds,uestc-true-speeds}.csv
touch "$folder/cwru/tables.md" "$folder/cwru/figures/"{cost,cost@wdcnn-orders,gains}.svg
MAKE
  cat >pipeline/figures/draw.sh <<'DRAW'
#!/bin/bash
cat "${@:2}" >/dev/null && mkdir -p "${1%/*}" && echo "${@:2}" >"${1%.csv}.svg"
DRAW
  chmod +x remake
  # Real programs but for the one that is run without make.
  mkdir programs
  ln -s "$programs"/* programs
  rm programs/teach
  # shellcheck disable=SC2016 # the script's own argument
  printf '#!/bin/bash\necho "$*" >"${@: -1}"\n' >programs/teach
  chmod +x programs/teach
}
commit() {
  git add CMakeLists.txt src stages pipeline
  git -c user.name=a -c user.email=b commit --quiet --message=c
}
reference_all() { DATA_DIR=recordings BIN=programs pipeline/reference_all.sh ./remake; }
all_parts() { reference_all >messages 2>&1 || fail "$(<messages)"; }

test_every_request_is_valid() {
  lay_out
  mkdir recordings
  all_parts
  local request
  while IFS= read -r request; do
    [[ $request != reference* ]] || continue
    # The values have spaces: NAME=a b NAME=c.
    mapfile -t requested < <(sed -E 's/ ([A-Z_]+=)/\n\1/g' <<<"$request")
    make --silent plan "${requested[@]}" >messages 2>&1 || fail "make $request: $(<messages)"
    expect_line "$(<messages)" '^[0-9]+ steps?: '
  done <requests
}

test_every_computed_run_is_stored() {
  lay_out
  all_parts
  local run
  while IFS= read -r run; do
    expect_line "$(grep '^reference' requests)" "$run "
  done < <(grep -vE '^(reference|readings) ' requests | grep -oE 'RUN=[^ ]+' | sort -u)
  expect_equal "$(cd results/reference/readings && find . -type f)" ./random/cwru/readings.md
  expect_equal "$(<results/reference/any-bearing.h5)" \
    '--config pipeline/protocol.toml --output results/reference/any-bearing.h5'
  expect_line "$(<results/reference/random/rigs.svg)" 'transfer@speeds.csv .*transfer@uestc-speeds.csv '
}

test_rivals_and_classifiers_keep_their_tables_and_of_the_figures_cost() {
  lay_out
  all_parts
  local folder
  for folder in rivals classifiers; do
    expect_equal "$(cd results/reference/$folder && find . -type f ! -name 'transfer@*' | LC_ALL=C sort | xargs)" \
      './random/cwru/figures/cost.svg ./random/cwru/figures/cost@wdcnn-orders.svg ./random/cwru/tables.md'
  done
  expect_line "$(ls results/reference/random/cwru/figures)" '^gains.svg$'
}

test_stored_parts_are_skipped_until_programs_or_settings_change() {
  lay_out
  all_parts
  expect_equal "$(tail -n +2 $list | cut -d, -f2 | sort -u)" "$(decisive_commit HEAD)"
  expect_equal "$(cut -d' ' -f3 results/reference/SHA256SUMS)" \
    "$(cd results/reference && find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort)"
  expect_line "$(<results/reference/SHA256SUMS)" '  parts.csv$'
  (cd results/reference && sha256sum --check --quiet SHA256SUMS) || fail "the sums are older than the parts"
  rm requests
  git config core.abbrev 12
  expect_line "$(reference_all)" '^reference-all: zero is stored$'
  [[ ! -e requests ]] || fail "made again: $(<requests)"
  local first
  first=$(decisive_commit HEAD)
  echo "# another value" >>pipeline/protocol.toml
  expect_line "$(reference_all 2>&1 || true)" 'differ from their last commit'
  [[ ! -e requests ]] || fail "made from what was not committed: $(<requests)"
  commit
  all_parts
  expect_line "$(<requests)" "^verdicts .* RUN=zero-$(decisive_commit HEAD)"
  expect_no_line "$(<requests)" "RUN=zero-$first"
  expect_equal "$(tail -n +2 $list | cut -d, -f2 | sort -u)" "$(decisive_commit HEAD)"
}

test_the_commit_must_be_known() {
  lay_out
  git clone --quiet --depth 1 "file://$PWD" shallow
  expect_line "$(GIT_DIR=shallow/.git reference_all 2>&1 || true)" 'needs a whole clone by git'
  expect_line "$(GIT_DIR=nothing reference_all 2>&1 || true)" 'needs a whole clone by git'
  mkdir unpacked
  cp -r CMakeLists.txt src stages pipeline remake unpacked # a tarball inside this repository
  expect_line "$({ cd unpacked && reference_all; } 2>&1 || true)" 'needs a whole clone by git, of its own'
}

test_a_failed_part_is_not_stored_and_the_same_command_continues_with_it() {
  lay_out
  echo "verdicts CLASSIFIERS" >broken
  expect_exit 1 reference_all
  expect_no_line "$(<$list)" '^zero,'
  expect_no_line "$(<requests)" '^reference .*RUN=zero'
  expect_line "$(<$list)" '^cwru,'
  rm broken requests
  all_parts
  expect_no_line "$(<requests)" '^sweep DATASETS=cwru '
  expect_line "$(<$list)" '^zero,'
}

run_tests "$@"
