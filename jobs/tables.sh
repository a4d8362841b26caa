#!/bin/bash
# The tables of a run after its jobs, of what there is: nothing of the grid is computed here. What is
# missing is named. Prints at the end what was spent. Exits with 1 if anything is missing.
# usage: jobs/tables.sh FOLDER GOAL VARIABLE=VALUE...      FOLDER and GOAL are those of jobs/submit.sh
set -uo pipefail
# shellcheck source=jobs/common.sh
source jobs/common.sh

folder=$1 goal=$2
shift 2
results=$(value_of results "$@")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 75' TERM INT HUP
grid=(make --file=pipeline/grid.mk "$@")
fact() { "$(value_of BIN "${grid[@]}")/settings" --facts | sed -n "s/^$1://p"; }

# The steps that make would run for a goal, without those of the tables themselves.
steps_of() { # goal, variables
  "${grid[@]}" --dry-run "$@" 2>"$scratch/errors" | awk -f jobs/steps.awk |
    grep -P '\t(ingest|simulate|split|train|generate|score|diagnose|features)\t'
}

# Of a grid with holes the tables are made all the same, of all cells that are there: where one cell is asked
# for that is, make finds the others by itself.
tables_with_holes() { # data set
  local file method ratio seed classifier cells bar
  bar=$(fact bar)
  "${grid[@]}" "DATASETS=$1" --dry-run list-cells 2>/dev/null | sed -n 's/^cell //p' >"$scratch/cells"
  while IFS= read -r file; do
    [[ $file == */diagnosis.h5 && -f $file ]] || continue
    IFS=/ read -r _ _ _ seed method ratio classifier _ <<<"$file"
    cells=$seed/$method/$ratio
    # The baseline has the bar beside it, whichever classifier is asked for.
    ! grep -qE "^results/[^/]+/$1/($seed|$seed/$method|$cells/$classifier|$cells/$bar)"$'\t' "$scratch/steps" || continue
    "${grid[@]}" "DATASETS=$1" "SEEDS=${seed#seed}" "METHODS=$method" "RATIOS=$ratio" "CLASSIFIERS=$classifier" \
      tables && return
  done <"$scratch/cells"
  echo "$results/$1: no cell is complete, so there are no tables" >&2
  return 1
}

# Other tables are of the seeds of which nothing is missing.
complete_seeds() {
  local seed
  # shellcheck disable=SC2016 # make expands it
  for seed in $("${grid[@]}" --eval='print-seeds: ; @echo $(SEEDS)' print-seeds); do
    grep -q "/seed${seed}[/"$'\t'] "$scratch/steps" || echo "$seed"
  done
}

name_the_holes() {
  awk -F '\t' '$2 != "split" && $2 != "generate" { print $4 }' "$scratch/steps" >"$scratch/holes"
  echo "missing: $(wc -l <"$scratch/holes") files that the tables are made of" >&2
  sed 's/^/  /' "$scratch/holes" | head -n 100 >&2
  (($(wc -l <"$scratch/holes") <= 100)) || echo "  ... (the first 100)" >&2
}

with_holes() {
  local dataset seeds
  name_the_holes
  if [[ $goal == all || $goal == cells ]]; then
    for dataset in $(value_of DATASETS "$@" | tail -n 1); do tables_with_holes "$dataset"; done
    [[ $goal == cells ]] || "${grid[@]}" cells_given= report
  else
    seeds=$(complete_seeds | xargs)
    if [[ $seeds ]]; then
      echo "the tables are of these seeds alone: $seeds" >&2
      "${grid[@]}" "SEEDS=$seeds" "$goal"
    else
      echo "of no seed there is all, so there are no tables" >&2
    fi
  fi
}

# Steps are counted by their logs.
spent() {
  local folders
  mapfile -t folders < <(find "$folder" -maxdepth 1 \( -name records -o -name 'cells*' \) ! -name '*.log' \
    -exec cut -d / -f -2 {} + | sort -u)
  awk -f jobs/spent.awk -v submitted="$(stat --format=%Y "$folder/choice")" -v now="$(date +%s)" \
    -v steps="$(find "${folders[@]:-$results}" -name .jobs -prune -o -name '*.log' -newer "$folder/choice" \
      -exec grep -l '^step: exit 0 ' {} + | wc -l)" "$folder"/*.log
}

wanted=("$goal")
[[ $goal != all ]] || wanted=(tables features)
steps_of "${wanted[@]}" >"$scratch/steps"
status=0
if [[ -s $scratch/steps ]]; then
  with_holes "$@"
  status=1
else
  [[ $goal == cells ]] || "${grid[@]}" "$goal" || status=$?
fi
spent
exit "$status"
