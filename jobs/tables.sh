#!/bin/bash
# Makes the tables of a run after its jobs from what exists, without computing anything of the grid. Names what is
# missing, and finally prints what was spent. Exits with 1 if anything is missing.
# usage: jobs/tables.sh FOLDER      FOLDER is that of jobs/submit.sh
set -uo pipefail
# shellcheck source=jobs/common.sh
source jobs/common.sh

take_choice "$1"
trap 'exit 75' TERM INT HUP

status=0
missing=$("$BIN/plan" --looks --format missing) || status=$?
if [[ $missing ]]; then
  printf '%s\n' "$missing" >&2
  export PIAE_WITH_HOLES=yes
  status=1
fi
[[ $GOALS == cells ]] || pipeline/run.sh make || status=$?
"$BIN/status" --spent "$1"
exit "$status"
