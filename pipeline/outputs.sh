# shellcheck shell=bash
# shellcheck disable=SC2154 # step.sh sets what it reads
# What a step makes, and whether it has; to be sourced by step.sh, whose variables it reads.

time_of() { stat --format=%.6Y "$1"; }

# Whether a file has been made anew: a stage writes beside it and renames. A file that was not there needs no
# looking at.
identity() { stat --format='%i %y' "$1" 2>/dev/null; }
note_what_is_there() {
  was=()
  checkpoint_was=
  [[ ! -e ${makes[0]:-}.checkpoint ]] || checkpoint_was=$(identity "${makes[0]}.checkpoint")
  local i
  for i in "${!makes[@]}"; do
    was[i]=
    [[ ! -e ${makes[i]} ]] || was[i]=$(identity "${makes[i]}")
  done
}
all_are_new() {
  local i is
  for i in "${!makes[@]}"; do
    missing_output=${makes[i]}
    # To open a file makes a network's file system look how it is now.
    { : <"$missing_output"; } 2>/dev/null || return
    [[ ! ${was[i]} ]] || { is=$(identity "$missing_output") && [[ $is != "${was[i]}" ]]; } || return
  done
  missing_output=
}
# A stage that has ended by itself has said what it used. Then a file that another node has made may come
# into sight late. The numbers of figures that are as they were are left as they are: there it says enough.
made_anew() {
  local tries=0
  missing_output=
  if ((${#makes[@]} == 0)); then
    [[ ! $SUBMIT ]] || log_has '^step: used '
    return
  fi
  until all_are_new; do
    [[ $SUBMIT ]] && ((tries++ < 60)) && log_has '^step: used ' || return
    sleep 1
  done
  return 0 # not what a sleep returned that was signalled together with this script
}

# True if the stage was interrupted and has left a checkpoint. Waits for it where the stage may still be running:
# a stage that has ended by itself has reported what it used. Of a step that was not told to stop, only a
# checkpoint written from now on counts; an earlier one does not tell a lost node from an interrupted stage.
left_checkpoint() {
  local checkpoint tries=0
  ((${#makes[@]})) && ! all_are_new || return
  [[ $stopped ]] || checkpoint_was=$(identity "${makes[0]}.checkpoint")
  until checkpoint=$(identity "${makes[0]}.checkpoint") && [[ $checkpoint != "$checkpoint_was" ]]; do
    ((tries++ < 5 * ${CHECKPOINT_WITHIN:-30})) && ! log_has '^step: used ' && ! all_are_new || return
    sleep 0.2
  done
  return 0 # as above
}
