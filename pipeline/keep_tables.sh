#!/bin/bash
# Copies the tables that people read from a run to where its reference is kept: FOLDER/<dataset>/*.md.
# usage: pipeline/keep_tables.sh results/RUN FOLDER
set -euo pipefail
shopt -s nullglob

run=$1 folder=$2
for table in "$run"/*/*.md; do
  kept=$folder/${table#"$run"/}
  mkdir -p "${kept%/*}"
  cp "$table" "$kept"
  printf 'kept %s\n' "$kept"
done
