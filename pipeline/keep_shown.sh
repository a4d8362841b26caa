#!/bin/bash
# Copies the tables and figures of a run to its reference: FOLDER/<dataset>/*.md, verdicts and readings as .csv and .svg,
# figures/*.csv and *.svg, and for several data sets FOLDER/transfer*@<group>.md, .csv and .svg, and rigs.svg.
# Then renews results/reference/SHA256SUMS.
# usage: pipeline/keep_shown.sh results/RUN FOLDER
set -euo pipefail
shopt -s nullglob

run=$1 folder=$2
mkdir -p "$folder"
for table in "$run"/*/*.md "$run"/*/{verdicts,readings}.{csv,svg} "$run"/{transfer*@*.{md,csv,svg},rigs*.svg}; do
  kept=$folder/${table#"$run"/}
  mkdir -p "${kept%/*}"
  cp "$table" "$kept"
  printf 'kept %s\n' "$kept"
done
for figures in "$run"/*/figures; do
  kept=$folder/${figures#"$run"/}
  rm -rf "$kept" # including figures that the run no longer has
  mkdir -p "$kept"
  cp "$figures"/*.csv "$figures"/*.svg "$kept"
  printf 'kept %s\n' "$kept"
done
pipeline/sums.sh
