#!/bin/bash
# Lays out what CONTRIBUTING.md shows of a new method, letter for letter: its files, and the registry
# with its line.
# usage: lay_out.sh PROJECT FOLDER
set -euo pipefail

project=$1 folder=$2
mkdir -p "$folder/augment"
# A block of code names its file in the first line.
awk -v folder="$folder" '
  /^```/ { file = "" }
  /^\/\/ src\/augment\/[a-z_.]+/ {
    file = folder substr($2, 4)
    sub(/,$/, "", file)
    if (file ~ /registry/) file = folder "/line"
    printf "" >file
    next
  }
  file { print >file }' "$project/CONTRIBUTING.md"
awk -v line="$(<"$folder/line")" '
  /^#include "augment\/physics.hpp"/ { print "#include \"augment/reverse.hpp\"" }
  /^};$/ { print line }
  { print }' "$project/src/augment/registry.cpp" >"$folder/augment/registry.cpp"
