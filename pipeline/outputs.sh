# shellcheck shell=bash
# shellcheck disable=SC2154 # step.sh sets what it reads
# Outputs of a step and checks of them; to be sourced by step.sh, whose variables it reads.

time_of() { stat --format=%.6Y "$1"; }

# Identifies a version of a file, to detect that a stage has remade it: stages write a new file and rename it. Files
# that did not exist before are not checked.
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
    # Opening a file refreshes the view of a network file system.
    { : <"$missing_output"; } 2>/dev/null || return
    [[ ! ${was[i]} ]] || { is=$(identity "$missing_output") && [[ $is != "${was[i]}" ]]; } || return
  done
  missing_output=
}
# True if the stage has made its outputs. A stage that has ended by itself has reported its usage; outputs written on
# another node may then appear late. Unchanged numbers of figures are not rewritten, so for steps without outputs that
# report is enough.
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
  return 0 # a sleep that was signalled together with this script returns another code
}

# True if the stage was interrupted and left a checkpoint. Waits for the checkpoint while the stage may still be
# running: a stage that has ended by itself has reported its usage. If the step was not signalled, only a checkpoint
# written from now on counts, because an earlier one does not distinguish a lost node from an interrupted stage.
left_checkpoint() {
  local checkpoint tries=0
  ((${#makes[@]})) && ! all_are_new || return
  [[ $stopped ]] || checkpoint_was=$(identity "${makes[0]}.checkpoint")
  until checkpoint=$(identity "${makes[0]}.checkpoint") && [[ $checkpoint != "$checkpoint_was" ]]; do
    ((tries++ < 5 * ${CHECKPOINT_WITHIN:-30})) && ! log_has '^step: used ' && ! all_are_new || return
    sleep 0.2
  done
  return 0 # see made_anew
}
