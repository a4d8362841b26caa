#!/bin/bash
# Makes the tables of a run. Where a cell fails, the table stage is asked all the same, and names every
# cell that is missing; with make's -k, after all the others are done. A data set of which there are
# not even the records has said why, and needs no list of all its cells. With --show, what some figures
# need is made beside the cells; then the figures are drawn and the report is written, of what there is.
# usage: pipeline/tables.sh [--show] MAKE OPTION...
set -u

goals=(tables)
if [[ $1 == --show ]]; then
  goals+=(features)
  shift
fi
make=("$@")
stopped=

# As in step.sh: a signal is passed on, and make waited for.
run() { # goal...
  "${make[@]}" "$@" &
  local child=$! signalled=1 status
  trap 'stopped=yes signalled=1; kill -TERM "$child" 2>/dev/null' INT TERM HUP QUIT
  while ((signalled)); do
    signalled=0
    wait "$child"
    status=$?
  done
  return "$status"
}

cells_to_be_made() { # folder of the data set, the steps
  awk -v inside="$1/" '$1 == "pipeline/step.sh" && index($2, inside) == 1 {
    if ($3 == "diagnose") print $2 "/diagnosis.h5"
    if ($3 == "score") print $2 "/score.h5" }' <<<"$2"
}

# A cell that is there but was to be made again is a hole, too.
name_the_holes() {
  local steps script folder stage options cells outdated words
  # The steps that are still to be done, a command each; make shows a long one as several lines.
  steps=$("${make[@]}" --dry-run tables 2>/dev/null | sed -e ':join' -e '/\\$/ { N; s/\\\n//; b join' -e '}')
  while read -r script folder stage options; do
    [[ $script == pipeline/step.sh && $stage == tabulate ]] || continue
    grep -qE "^pipeline/step.sh $folder (ingest|simulate) " <<<"$steps" && continue
    mapfile -t cells < <(cells_to_be_made "$folder" "$steps")
    ((${#cells[@]})) || continue
    outdated=()
    for cell in "${cells[@]}"; do [[ ! -f $cell ]] || outdated+=(--outdated "$cell"); done
    read -ra words <<<"$options"
    # Its settings may not have been written yet: make has stopped before.
    "${make[@]}" "${words[1]}" # --config FILE
    "$script" "$folder" "$stage" "${outdated[@]}" "${words[@]}" >/dev/null
  done <<<"$steps"
  echo "not every cell could be made; make status, with the same variables, shows which failed and why" >&2
}

run "${goals[@]}"
status=$?
# 1 is what make -q answers when there is something to do.
((status <= 1)) || [[ $stopped ]] || name_the_holes
((${#goals[@]} == 1)) || for goal in draw page; do
  [[ $stopped ]] || run "$goal" || status=$((status ? status : $?))
done
exit "$status"
