#!/bin/bash
# Commands in the README and on the page about own recordings can be typed as shown, with the built programs.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# Prints the first block of commands in a section of a page.
commands_of() { # page, title of the section
  awk -v title="## $2" '/^## / { inside = ($0 == title) }
    inside && /^    / { print substr($0, 5); found = 1; next }
    found { exit }' "$project/$1"
}

test_the_chain_by_hand_of_the_readme_runs() {
  mkdir build
  ln -s "$programs" build/bin
  commands_of README.md 'One stage by hand' >chain
  expect_line "$(<chain)" '^verify '
  bash -e chain >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<messages)" '^diagnosed 700 windows'
}

# Prints the n-th description on the page. "..." stands for values that only the reader knows.
shown_description() {
  # shellcheck disable=SC2016
  awk -v n="$1" '/^```toml/ { inside = ++shown == n; next } /^```/ { inside = 0 } inside' "$project/pipeline/datasets/README.md" |
    sed '/= "\(https:\/\/\)\?\.\.\."/d'
}

# Their only error is that the recordings are missing.
test_the_descriptions_of_the_pages_have_known_keys() {
  shown_description 1 >rig.toml
  expect_line "$(<rig.toml)" '^name = "rig"'
  expect_exit 66 "$programs/ingest" --check --description rig.toml --data-dir .
  shown_description 2 >rig-1200to900.toml
  expect_line "$(<rig-1200to900.toml)" '^like = "rig"'
  expect_exit 66 "$programs/ingest" --check --description rig-1200to900.toml --data-dir .
}

run_tests "$@"
