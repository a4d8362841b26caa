#!/bin/bash
# What the folder of a data set holds that make would make again: files, and folders with all that is
# in them, below that folder, one a line. Reads only. Make itself says it, by the settings as they are
# now; so the goal must be one with rules for all that is there.
# usage: pipeline/out_of_date.sh results/RUN/DATASET MAKE VARIABLE=VALUE... GOAL
set -euo pipefail
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

folder=$1
shift
seeds=$(find "$folder" -maxdepth 1 -name 'seed*' -printf '%f\n' 2>/dev/null |
  sed -nE 's/^seed(0|[1-9][0-9]*)$/\1/p' | sort -n | xargs)
[[ $seeds ]] || exit 0

# What a step makes, and all that is made of it; what lies in a folder that is named is not named again.
steps=$("$@" --dry-run SEEDS="$seeds")
awk -v folder="$folder" -v seeds="$seeds" '
  $1 != "pipeline/step.sh" || index($2 "/", folder "/") != 1 { next }
  { below = substr($2, length(folder) + 2) }
  $3 == "ingest" || $3 == "simulate" {
    count = split(seeds, seed, " ")
    for (i = 1; i <= count; ++i) again["seed" seed[i]]
  }
  $3 == "split" || $3 == "train" || $3 == "generate" { again[below] }
  $3 == "score" { again[below "/score.h5"] }
  $3 == "diagnose" { again[below "/diagnosis.h5"] }
  END {
    for (name in again) {
      above = name
      while (sub(/\/[^\/]*$/, "", above)) if (above in again) break
      if (above == name || !(above in again)) print name
    }
  }' <<<"$steps" | LC_ALL=C sort |
  while IFS= read -r name; do
    [[ ! -e $folder/$name ]] || echo "$name"
  done
