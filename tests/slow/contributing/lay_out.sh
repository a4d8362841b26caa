#!/bin/bash
# Lays out the examples of CONTRIBUTING.md (data set, method, classifier, table, column, figure, stage, goal), letter for
# letter: its files, and copies of ours with its additional lines.
# usage: lay_out.sh PROJECT FOLDER
set -euo pipefail

project=$1 folder=$2
lines=$folder/lines
mkdir -p "$lines"

# A block of code names its file in the first line. If the name continues with `, with #include X above`, the block
# holds lines for one of our files: they go to a separate folder, after X.
awk -v folder="$folder" -v lines="$lines" '
  /^```/ { inside = !inside; first = inside; file = ""; next }
  first && /^(\/\/|#) (src|stages|pipeline)\/[^ ]+\.(cpp|hpp|toml|gp)/ {
    first = 0
    is_part = sub(/,$/, "", $2)
    file = (is_part ? lines : folder) "/" $2
    system("mkdir -p \"$(dirname \"" file "\")\"")
    sub(/.*#include /, ""); sub(/ above$/, "")
    printf "%s", is_part ? $0 "\n" : "" >file
    next
  }
  { first = 0 }
  file { print >file }' "$project/CONTRIBUTING.md"

# Inserts the lines into our file, before the only line that matches, and adds the header.
add_lines() { # file, pattern
  local added=$lines/$1
  mkdir -p "$folder/$(dirname "$1")"
  awk -v pattern="$2" -v header="$(head -1 "$added")" -v added="$(tail -n +2 "$added")" '
    $0 ~ pattern { print added; found++ }
    { print }
    FNR == 1 { print "#include " header }
    END { exit found != 1 }' "$project/$1" >"$folder/$1" ||
    { echo "lay_out.sh: not one line of $1 is like $2" >&2 && exit 1; }
}
add_lines src/augment/catalogue.cpp '^};$'
add_lines src/diagnosis/catalogue.cpp '^};$'
add_lines src/report/accuracy_columns.cpp '^};$'
add_lines src/report/tables.cpp '^  return sections;$'
add_lines src/figures/catalogue.cpp '^};$'
add_lines src/plan/goals.cpp '^ *{.name = "figures",'
