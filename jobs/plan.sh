#!/bin/bash
# Plans what is still to be done as jobs: writes into a folder what each of them makes, and prints the plan.
# usage: jobs/plan.sh FOLDER GOAL VARIABLE=VALUE...      (make's variables, and CORES, MINUTES)
# FOLDER gets `jobs`, a line for each kind of job, and a file for each job (jobs/plan.awk).
set -euo pipefail
# shellcheck source=jobs/common.sh
source "${0%/*}/common.sh"
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

folder=$1 goal=$2
shift 2
bin=$(value_of BIN "$@")
# `make all` is the tables and what some figures need beside them.
goals=("$goal")
[[ $goal != all ]] || goals=(tables features)

make --file=pipeline/grid.mk "$@" --dry-run "${goals[@]}" >"$folder/answer"
awk -f jobs/steps.awk "$folder/answer" >"$folder/steps"

# What asks for a GPU by its settings, be it a method or a stage for all of them.
asks_for_gpu() { # settings file
  rm -rf "$folder/settings"
  "$bin/settings" --folder "$folder/settings" --update "$1.toml" &&
    grep -qE '^device = .cuda' "$folder/settings/$1.toml"
}
gpu_methods='' gpu_stages=''
while read -r method; do
  ! asks_for_gpu "train.$method" || gpu_methods+=" $method"
done < <(cut -f 3 "$folder/steps" | sort -u | grep .)
for stage in generate diagnose; do ! asks_for_gpu "$stage" || gpu_stages+=" $stage"; done
[[ $gpu_stages != *diagnose* ]] || gpu_stages+=" features"

awk -f jobs/plan.awk -v out="$folder" -v cores="$(value_of CORES "$@")" \
  -v minutes="$(value_of MINUTES "$@")" -v papers="$("$bin/settings" --facts | sed -n 's/^paper-method://p')" \
  -v gpu_stages="$gpu_stages" -v gpu_methods="$gpu_methods" jobs/costs.csv "$folder/steps" >"$folder/plan"
grep -v '^unknown' "$folder/plan" >"$folder/jobs"
rm -rf "$folder/settings" "$folder/answer" "$folder/steps"

awk -F '\t' '
  function hours(minutes) { return sprintf("%d:%02d h", minutes / 60, minutes % 60) }
  function memory(megabytes) { return sprintf("%.1f GB", megabytes / 1000) }
  BEGIN {
    printf "%-10s %6s %6s %10s %10s %7s %11s\n", "job", "number", "cores", "time each", "memory", "steps", \
      "core-hours"
  }
  $1 == "unknown" { guessed = guessed "\nno cost is known of " $2 ": the largest is taken (jobs/costs.csv)"; next }
  { printf "%-10s %6d %6d %10s %10s %7d %11.2f\n", $1, $2, $3, hours($4), memory($5), $6, $7 / 3600
    number += $2; steps += $6; seconds += $7; asked += $2 * $3 * $4 / 60; ++submissions }
  END {
    printf "%-10s %6d %6s %10s %10s %7d %11.2f\n", "all", number, "", "", "", steps, seconds / 3600
    printf "%d submissions, which ask for %.1f core-hours at most%s\n", submissions, asked, guessed
  }' "$folder/plan"
