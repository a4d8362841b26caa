#!/bin/bash
# Makes the tables of a run. Where a cell fails, the table stage is asked all the same, and names every
# cell that is missing; with make's -k, after all the others are done. A data set of which there are
# not even the records has said why, and needs no list of all its cells.
# usage: pipeline/tables.sh MAKE OPTION...
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
# 1 is what make -q answers when there is something to do.
((status <= 1)) || [[ $stopped ]] && exit "$status"

# The steps that are still to be done, a command each; make shows a long one as several lines.
steps=$("$@" --dry-run tables 2>/dev/null | sed -e ':join' -e '/\\$/ { N; s/\\\n//; b join' -e '}')
cells_to_be_made() { # folder of the data set
  awk -v inside="$1/" '$1 == "pipeline/step.sh" && index($2, inside) == 1 {
    if ($3 == "diagnose") print $2 "/diagnosis.h5"
    if ($3 == "score") print $2 "/score.h5" }' <<<"$steps"
}

# A cell that is there but was to be made again is a hole, too.
while read -r script folder stage options; do
  [[ $script == pipeline/step.sh && $stage == tabulate ]] || continue
  grep -qE "^pipeline/step.sh $folder (ingest|simulate) " <<<"$steps" && continue
  mapfile -t cells < <(cells_to_be_made "$folder")
  ((${#cells[@]})) || continue
  outdated=()
  for cell in "${cells[@]}"; do [[ ! -f $cell ]] || outdated+=(--outdated "$cell"); done
  read -ra words <<<"$options"
  "$script" "$folder" "$stage" "${words[@]}" "${outdated[@]}" >/dev/null
done <<<"$steps"
echo "not every cell could be made; make status, with the same variables, shows which failed and why" >&2
exit "$status"
