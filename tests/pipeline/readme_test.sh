#!/bin/bash
# What the README and the page on own recordings show can be typed as it stands there: with the built
# programs.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

# The first block of commands in a section of a page.
commands_of() { # page, title of the section
  awk -v title="## $2" '/^## / { inside = ($0 == title) }
    inside && /^    / { print substr($0, 5); found = 1; next }
    found { exit }' "$project/$1"
}

test_the_chain_of_one_stage_by_hand_runs_and_its_files_are_good() {
  mkdir build
  ln -s "$programs" build/bin
  commands_of README.md 'One stage by hand' >chain
  expect_line "$(<chain)" '^verify '
  bash -e chain >messages 2>&1 || fail "$(<messages)"
  expect_line "$(<messages)" '^diagnosed 700 windows'
}

test_the_shown_description_has_the_keys_that_ingest_knows() {
  # shellcheck disable=SC2016
  sed -n '/^```toml/,/^```/ { /^```/d; p }' "$project/pipeline/datasets/README.md" >shown.toml
  expect_line "$(<shown.toml)" '^name = "rig"'
  # "..." stands for what only the reader knows.
  sed -i '/= "\(https:\/\/\)\?\.\.\."/d' shown.toml
  # Nothing is wrong with it but that the recordings are not there.
  expect_exit 66 "$programs/ingest" --check --description shown.toml --data-dir .
}

run_tests
