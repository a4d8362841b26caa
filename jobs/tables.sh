#!/bin/bash
# The tables of a run after its jobs, of what there is: nothing of the grid is computed here. What is missing is named.
# Prints at the end what was spent. Exits with 1 if anything is missing.
# usage: jobs/tables.sh FOLDER      FOLDER is that of jobs/submit.sh
set -uo pipefail
# shellcheck source=jobs/common.sh
source jobs/common.sh

folder=$1
take_choice "$folder"
trap 'exit 75' TERM INT HUP

# Steps are counted by their logs.
spent() {
  local folders
  mapfile -t folders < <(find "$folder" -maxdepth 1 \( -name records -o -name 'cells*' \) ! -name '*.log' \
    -exec cut -d / -f -2 {} + | sort -u)
  awk -f jobs/spent.awk -v submitted="$(stat --format=%Y "$folder/choice")" -v now="$(date +%s)" \
    -v steps="$(find "${folders[@]:-$(run_folder)}" -name .jobs -prune -o -name '*.log' -newer "$folder/choice" \
      -exec grep -l '^step: exit 0 ' {} + | wc -l)" "$folder"/*.log
}

status=0
missing=$("$BIN/plan" --looks --format missing) || status=$?
if [[ $missing ]]; then
  printf '%s\n' "$missing" >&2
  export PIAE_WITH_HOLES=yes
  status=1
fi
[[ $GOALS == cells ]] || pipeline/run.sh make || status=$?
spent
exit "$status"
