#!/bin/bash
# Makes the request stretch by stretch: the grid with its tables, the numbers of figures, their pictures, the pages.
# Each stretch is planned after the previous one; figures and pages show what exists, even after failed cells.
# build/bin/plan decides what is to be done; make runs it.
# usage: pipeline/run.sh MAKE      with GOALS, RUN, DATASETS, ... in the environment, as the Makefile sets them
# shellcheck disable=SC2016 # messages have commands in backquotes
set -u

make=$1 flags=${MAKEFLAGS:-} status=0 stopped=
flags=${flags%% *}
plan() { "$BIN/plan" "$@"; }

# make -n does not build the programs, so they may be missing or too old to print a plan.
if [[ $flags == *n* ]]; then
  if [[ ! -x $BIN/plan ]] || { [[ $BIN == build/bin ]] && ! plan --looks >/dev/null 2>&1 &&
    [[ $(find src stages -newer "$BIN/plan" -print -quit 2>/dev/null) ]]; }; then
    echo 'to list the steps of the grid, build the programs first: `make build`'
    exit
  fi
fi

scratch=$(mktemp) || exit
trap 'rm -f "$scratch"' EXIT
options=()
[[ ${V:-} ]] || options+=(--quietly)
[[ $flags != *[nq]* ]] || options+=(--looks)

# Pass signals on and wait for make: stages may be writing checkpoints. If this script is killed, make must end, too:
# otherwise the make that called it waits for its job slots.
run_make() { # further options
  setpriv --pdeathsig TERM "$make" "$@" --no-builtin-rules --no-print-directory --file="$scratch" steps &
  local child=$! signalled=1 code
  trap 'stopped=yes signalled=1; kill -TERM "$child" 2>/dev/null' INT TERM HUP QUIT
  while ((signalled)); do
    signalled=0
    wait "$child"
    code=$?
  done
  return "$code"
}

next=grid
while :; do
  export PLANNED_AT=$EPOCHREALTIME
  plan --format make --stretch "$next" "${options[@]}" >"$scratch" || exit
  read -r _ stretch next <"$scratch" # "# numbers pictures": the stretch to do, and the next one
  [[ $stretch != shown ]] || break
  export PIAE_STRETCH=$stretch
  further=()
  [[ $stretch == grid ]] || further=(--keep-going) # one failed figure must not stop the others
  run_make "${further[@]}" || status=$?
  [[ ! $stopped ]] || exit "$status"
  [[ $flags != *q* ]] || exit "$status"
  if [[ $stretch == grid ]] && ((status)); then
    plan --looks --format why >&2
    echo 'some steps failed, see above; `make status` with the same variables shows which, and why' >&2
  fi
done
((status)) || [[ $flags == *[nq]* ]] || tail --lines=+2 "$scratch"
exit "$status"
