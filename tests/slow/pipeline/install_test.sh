#!/bin/bash
# The installation, with the built programs: the command piae-dt runs stages and make in any folder, and every program
# has a manual page.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

version=$(sed -nE 's/^project\(.* VERSION ([0-9.]+) .*/\1/p' "$project/CMakeLists.txt")
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

# Installs once, for the first test that needs it.
installed() {
  PATH=$prefix/bin:$PATH
  [[ ! -e $prefix/bin/piae-dt ]] || return 0
  env -u DESTDIR cmake --install "${programs%/bin}" --prefix "$prefix" >messages 2>&1 || fail "$(<messages)"
}

# Runs as a user without write permission for the installation.
test_the_grid_runs_in_another_folder() {
  installed
  mkdir -p elsewhere/pipeline/datasets
  cd elsewhere
  cp "$project/tests/reference/tiny.toml" pipeline/datasets/tiny.toml
  cp "$project/tests/reference/protocol.toml" pipeline
  touch ../began
  piae-dt make all DATASETS=tiny METHODS="none smote" RATIOS="100to1 50to1" SEEDS=0 >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<messages)" '^piae-dt: lays out .* in .*/elsewhere$'
  expect_line "$(<results/paper/tiny/summary.txt)" '^smote '
  expect_line "$(head -n 1 results/paper/tiny/seed0/split.log)" '^bin/split '
  [[ -s results/paper/report.html ]] || fail "no report"
  cmp pipeline/protocol.toml "$project/tests/reference/protocol.toml" || fail "the settings of the folder were replaced"
  expect_equal "$(find "$prefix" -newer ../began)" ""
  # A second call has nothing to do, and does not mention the folder again.
  expect_no_line "$(piae-dt make cells DATASETS=tiny METHODS=none RATIOS=100to1 SEEDS=0 2>&1)" 'lays out|diagnose'
  # Commands of make in messages can be typed as shown.
  expect_line "$(make status DATASETS=tiny METHODS="none smote" RATIOS="100to1 50to1" SEEDS=0 2>&1)" '^all +4 +4 '
  # The paper's numbers and the stored reference are found.
  expect_line "$(realpath -e results/published/table8-9-methods.csv)" "^$(realpath "$prefix")/"
  expect_line "$(realpath -e results/reference/random/cwru.csv)" "^$(realpath "$prefix")/"
  piae-dt verify results/paper/tiny/records.h5 || fail "the records are not good"
}

test_a_stage_finds_the_programs_next_to_it() {
  installed
  printf '%s\n' 'name = "rig"' 'sample_rate_hz = 12000' 'shaft_speed_rpm = 1500' '[bearing]' 'balls = 9' \
    'ball_diameter_mm = 7.94' 'pitch_diameter_mm = 39' 'contact_angle_deg = 0' >rig.toml
  local class
  for class in none inner; do
    awk -v level=${#class} 'BEGIN { for (i = 0; i < 3000; ++i) print level * sin(i + level) }' >$class.csv
    printf '%s\n' '[[class]]' "name = \"$class\"" "defect = \"$class\"" >>rig.toml
    [[ $class == none ]] || echo 'defect_size_mm = 0.3' >>rig.toml
    printf '%s\n' '[[record]]' "class = \"$class\"" "file = \"$class.csv\"" 'variable = "1"' 'sample_rate_hz = 12000' >>rig.toml
  done
  expect_line "$(piae-dt ingest --description rig.toml --data-dir . --output records.h5 2>&1)" '^ingest: 2 records, 6000 samples '
}

test_every_program_is_installed_and_has_a_manual_page() {
  installed
  local source stage expected=()
  for source in "$project"/stages/*.cpp; do
    stage=$(basename "$source" .cpp)
    expected+=("$stage")
    [[ ! -e $programs/$stage-libtorch ]] || expected+=("$stage-libtorch")
    gzip -dc "$prefix/share/man/man1/piae-dt-$stage.1.gz" >text || fail "$stage has no page"
    expect_line "$(<text)" '^\.SH EXIT STATUS$'
    expect_line "$(<text)" "^piae\\\\-dt $stage "
    expect_line "$(piae-dt --help)" "^  $stage  +[A-Z]"
    expect_line "$(piae-dt "$stage" --version)" "^piae-dt $stage $version( |$)"
  done
  expect_equal "$(ls "$prefix/lib/piae-dt")" "$(printf '%s\n' "${expected[@]}" | LC_ALL=C sort)"
  expect_line "$(piae-dt --version)" "^piae-dt $version( |$)"
}

# A stage's line is its first sentence, or as many of its words as fit into 80 columns.
test_the_list_of_stages_describes_each() {
  installed
  local listed stage summary line said
  listed=$(COLUMNS='8 * 9' piae-dt --help | sed -n '/^Stages:$/,/^$/p' | sed '1d; $d')
  expect_equal "$(wc -l <<<"$listed")" "$(find "$project/stages" -name '*.cpp' | wc -l)"
  while read -r line; do
    ((${#line} <= 78)) || fail "wider than 80 columns: $line"
    read -r stage said <<<"$line"
    summary=$(piae-dt "$stage" --help | head -n 1)
    if [[ $said == *' ...' ]]; then
      said=${said%...}
      ((${#line} > 60)) || fail "cut too early: $line"
      [[ $summary == "$said"* ]] || fail "'$said' does not begin: $summary"
    else
      [[ "$summary " == "$said. "* ]] || fail "'$said' is not the first sentence of: $summary"
    fi
  done <<<"$listed"
  # Each stage is an entry of the manual page: its name has a line of its own.
  gzip -dc "$prefix/share/man/man1/piae-dt.1.gz" | sed -n '/^\.SH STAGES/,/^\.SH EXAMPLE/p' >page
  expect_equal "$(sed -nE 's/^\\fB([a-z_]+)\\fR$/\1/p' page)" "$(sed -E 's/^ +([a-z_]+) .*/\1/' <<<"$listed")"
  expect_no_line "$(<page)" '\.\.\.$'
}

# Each option has its text next to it or below, and dashes can be copied.
test_pages_match_the_help_of_the_programs() {
  installed
  local page=$prefix/share/man/man1/piae-dt-split.1.gz
  expect_line "$(gzip -dc "$page" | grep -A 1 '^.fB.-.-window.fR ')" '^Samples in a window$'
  expect_line "$(gzip -dc "$page" | grep -A 1 '^.fB.-.-max.-stride.fR ')" '^Largest distance between window starts'
  expect_line "$(gzip -dc "$page" | head -n 1)" "^\.TH \"PIAE-DT-SPLIT\" 1 \"[0-9-]{10}\" \"piae-dt $version\""
}

# Its name as CLI11 of Debian 12 prints it, and as that of Debian 13.
test_a_name_of_an_option_may_hold_two_spaces() {
  local name page
  for name in '  --seed INT:NATURAL=0 REQUIRED       ' '  --seed INT:NATURAL [0]  REQUIRED    '; do
    page=$(printf 'Trains.\nUsage: train [OPTIONS]\n\nOptions:\n%snumber of the repeat\n\n' "$name" |
      awk -v name=piae-dt-train -v command='piae-dt train' -v version=1 -v date=d -f "$project/packaging/man.awk")
    expect_line "$page" '^.fB.-.-seed.fR INT:NATURAL.* REQUIRED$'
    expect_line "$page" '^number of the repeat$'
  done
}

test_pages_are_clean() {
  installed
  command -v man >/dev/null || command -v mandoc >/dev/null || skip "neither man nor mandoc is installed"
  local page
  for page in "$prefix"/share/man/man1/*.gz; do
    gzip -dc "$page" >text
    if command -v mandoc >/dev/null; then expect_equal "$(mandoc -T lint -W warning text)" ""; fi
    if command -v man >/dev/null; then
      expect_equal "$(LC_ALL=C.UTF-8 man --warnings -E UTF-8 -l -Tutf8 -Z ./text 2>&1 >/dev/null)" ""
    fi
  done
}

test_the_installed_pages_lead_to_installed_files_and_the_licences_are_there() {
  installed
  cd "$prefix/share/doc/piae-dt"
  local page link name
  # Parameters in the code of a page look like links, but have spaces.
  grep -roE '\]\([^)#: ]+[)#]' --include='*.md' . | sed 's/:.*(/ /; s/.$//' >links
  expect_line "$(<links)" '^./README.md .*/fig15-gains.svg$'
  expect_line "$(<links)" '^./docs/own-machine.md .*/bearings.csv$'
  while read -r page link; do
    [[ -e ${page%/*}/$link ]] || fail "$page links to $link, which is not installed"
  done <links
  expect_equal "$(find "$prefix" -type d -empty)" ""
  for name in Eigen CLI11 'toml++' spdlog; do grep -qF "$name <" copyright || fail "the licence of $name is missing"; done
}

test_folders_of_other_projects_are_not_changed() {
  installed
  local name
  for name in Makefile bin jobs; do
    mkdir -p "of-$name" && echo "mine" >"of-$name/$name"
    (cd "of-$name" && expect_exit 2 piae-dt make help)
    expect_equal "$(ls "of-$name") $(<"of-$name/$name")" "$name mine"
  done
  expect_line "$(cd of-bin && piae-dt make help 2>&1)" '^piae-dt: .*/of-bin: has a bin of its own; '
}

test_links_are_renewed_and_files_stay() {
  installed
  mkdir folder
  cd folder
  piae-dt make help >/dev/null 2>&1
  ln -sfnT /nowhere/share/piae-dt/pipeline/step.sh pipeline/step.sh    # as another prefix has left it
  ln -sfnT /nowhere/share/piae-dt/pipeline/gone.sh pipeline/gone.sh    # as an older version has left it
  ln -sfnT /nowhere/protocol.toml pipeline/protocol.toml               # the user's own
  echo mine >pipeline/datasets/rig.toml
  rm pipeline/datasets/cwru.toml
  echo mine >pipeline/datasets/cwru.toml
  piae-dt make help >/dev/null 2>&1
  expect_equal "$(realpath pipeline/step.sh)" "$(realpath "$prefix")/share/piae-dt/pipeline/step.sh"
  expect_equal "$(readlink pipeline/protocol.toml)" /nowhere/protocol.toml
  expect_equal "$(cat pipeline/datasets/{rig,cwru}.toml)" $'mine\nmine'
  [[ ! -L pipeline/gone.sh ]] || fail "a link that leads nowhere is still there"
}

test_targets_that_need_the_sources_are_refused_in_one_line() {
  installed
  mkdir folder
  cd folder
  expect_line "$(piae-dt make help 2>/dev/null)" '^make demo '
  expect_no_line "$(piae-dt make help)" '^make (install|lint|test) |  PREFIX'
  local goal
  for goal in build test lint install package reference; do
    expect_line "$(piae-dt make $goal 2>&1)" "make $goal: needs a clone of the sources; "
    expect_exit 2 piae-dt make $goal
  done
}

test_an_unknown_stage_is_refused_in_one_line() {
  installed
  local name
  for name in nosuch ../bin/piae-dt train-libtorch . ''; do
    expect_exit 2 piae-dt "$name"
    expect_equal "$(piae-dt "$name" 2>&1 | wc -l)" 1
  done
  expect_line "$(piae-dt nosuch 2>&1)" "^piae-dt: there is no stage 'nosuch'; there are make and: .* split "
}

test_destdir_stands_for_the_root() {
  DESTDIR=$PWD/root cmake --install "${programs%/bin}" --prefix /opt/piae >messages 2>&1 || fail "$(<messages)"
  expect_equal "$(ls root/opt/piae)" $'bin\nlib\nshare'
  expect_line "$(root/opt/piae/bin/piae-dt --version)" "^piae-dt $version"
  [[ -s root/opt/piae/share/man/man1/piae-dt.1.gz ]] || fail "no manual page below DESTDIR"
}

# The first heading of CHANGELOG.md must be the version that is built.
test_the_list_of_changes_has_this_version() {
  expect_line "$version" '^[0-9]+\.[0-9]+\.[0-9]+$'
  expect_line "$(grep -m 1 '^## ' "$project/CHANGELOG.md")" "^## ${version//./\\.}, (not released yet|20[0-9]{2}-[0-9]{2}-[0-9]{2})$"
  local day
  day=$(grep -m 1 '^## ' "$project/CHANGELOG.md" | sed 's/.*, //')
  [[ $day == "not released yet" ]] || expect_line "$(<"$project/CITATION.cff")" "^date-released: $day$"
}

# Joins folded lines, since the other file may have the text in one line.
in_one_line() { sed 's/^> //' "$project/$1" | tr -s ' \n' ' '; }
test_the_citation_names_the_software_and_the_paper() {
  local cited readme title
  cited=$(in_one_line CITATION.cff) readme=$(in_one_line README.md)
  expect_line "$cited" "^cff-version: 1\.2\.0 message: .* type: software title: .* version: ${version//./\\.} .* authors: - name: .* license: MIT references: - type: article title: "
  for title in 'PIAE-DT: bearing fault data from a digital twin, as a batch pipeline' \
    'Physics-informed auto-encoder based on digital twin for rolling bearing fault diagnosis under imbalanced sample conditions'; do
    expect_line "$cited" "title: (>- |\")$title"
    expect_line "$readme" "\*$title\.\*"
  done
  expect_line "$readme" "\* Version ${version//./\\.}\. "
  # Both pages name the same people.
  expect_line "$readme" "$(grep -oE 'name: The .*' "$project/CITATION.cff" | cut -c 7-)\. \*PIAE-DT: "
  expect_line "$readme" "$(sed -nE 's/.*given-names: (.*)/\1/p' "$project/CITATION.cff" |
    paste -d ' ' - <(sed -nE 's/.*family-names: (.*)/\1/p' "$project/CITATION.cff") | paste -sd, | sed 's/,/, /g')\. \*Physics-informed"
  # Facts that the copy of the paper lacks must not be invented.
  expect_no_line "$(<"$project/CITATION.cff")" '^ *(doi|journal|year):'
}

run_tests "$@"
