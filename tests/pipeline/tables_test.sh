#!/bin/bash
# What of a TOML file counts as a setting.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/check.sh"

tables() { awk -v wanted="$1" -f pipeline/tables.awk example.toml; }

example() {
  cat >example.toml <<'TOML'
# top
title = "a # in a string" # and a comment
[train]   # a table
  epochs = 200
marks = ["]", '#', "\"#"]
[ train.vae ]
layers = [
  [1, 2],   # not a table
  [3],
]
[train.vae-2]
x = 1
[[record]]
file = 'a.mat'
[[record]]
file = 'b.mat'
TOML
}

test_one_table() {
  example
  expect_equal "$(tables train)" $'[train]\nepochs = 200\nmarks = ["]", \'#\', "\\"#"]'
}

test_a_table_below_another() {
  example
  expect_equal "$(tables train.vae)" $'[ train.vae ]\nlayers = [\n[1, 2],\n[3],\n]'
}

test_an_array_of_tables() {
  example
  expect_equal "$(tables record)" $'[[record]]\nfile = \'a.mat\'\n[[record]]\nfile = \'b.mat\''
}

test_a_table_that_is_not_there() {
  example
  expect_equal "$(tables score)" ""
}

test_the_whole_file() {
  example
  expect_equal "$(tables '' | wc -l)" 15
  expect_equal "$(tables '' | head -n 1)" 'title = "a # in a string"'
}

run_tests
