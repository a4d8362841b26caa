#!/bin/bash
# Makes the tables of a run. Where a cell fails, the table stage names every cell that is missing;
# with make's -k, after all the others are done.
# usage: pipeline/tables.sh MAKE VARIABLE=VALUE...
set -u

"$@" tables &
child=$!

# As in step.sh: a signal is passed on, and make waited for.
stopped=
signalled=1
trap 'stopped=yes signalled=1; kill -TERM "$child" 2>/dev/null' INT TERM HUP
while ((signalled)); do
  signalled=0
  wait "$child"
  status=$?
done
((status == 0)) || [[ $stopped ]] && exit "$status"

not_made=$(mktemp)
trap 'rm "$not_made"' EXIT
"$@" --dry-run cells | awk '$1 == "pipeline/step.sh" && $3 == "diagnose" { print $2 "/diagnosis.h5" }
                            $1 == "pipeline/step.sh" && $3 == "score" { print $2 "/score.h5" }' >"$not_made"
"$@" --keep-going --silent "NOT_MADE=$not_made" holes 2>&1 | grep -v '^make' >&2
echo "not every cell could be made; make status, with the same variables, shows which failed and why" >&2
exit "$status"
