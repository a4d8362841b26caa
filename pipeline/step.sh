#!/bin/bash
# Runs one stage for one folder of a run: a log beside what it makes, warnings and errors on
# standard error, one line when it is done. Whatever it prints begins with the cell it belongs to.
#
# The log is locked while the step runs. Its second line says when it began, by the clock of the file
# system, and its last two what the stage used, unless it was killed, and how it ended:
#   step: begun at 1763800000.123456
#   step: used 11.93 s of processor time and 153 MB of memory
#   step: exit 65 after 12.3 s
# Locked and without the last line, a step is running; not locked and without it, it was killed. `make
# status` and `make report` read this.
#
# usage: pipeline/step.sh results/RUN/DATASET/... STAGE OPTION...
# From the environment: BIN (folder of the programs), SUBMIT (a command to put before the stage),
# ASKED_AT (when make began to look what is to be done; may be missing), STEP_LOG (what the log is called
# where the stage has another step in the same folder; otherwise as the stage).
set -u
export LC_ALL=C    # numbers and times with a point
export PIAE_STEP=1 # the stage says on standard error what it used

folder=$1 stage=$2
shift 2
cell=${folder#results/*/}
log=$folder/${STEP_LOG:-$stage}.log
# A stage runs on one thread: make and the scheduler fill the cores. Only simulate, which everything
# else waits for, takes what there is.
[[ $stage == simulate ]] || export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
# shellcheck source=pipeline/environment.sh
source "${0%/*}/environment.sh"

report() { printf '%-32s %-8s %s\n' "$cell" "$stage" "$1"; }
# What comes in hundreds of lines is cut where a terminal ends; the log has it whole.
fit() { ((${#1} <= 100)) && echo "$1" || echo "${1:0:97}..."; }

show_and_log() {
  trap '' INT TERM HUP # it ends when the stage does
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    [[ $line != "step: used "* ]] || continue
    printf -v line '%-32s %s' "$cell" "$line"
    # How far a stage is, is cut; a warning or an error never.
    [[ $line != *" $stage  "[#.]* ]] || line=$(fit "$line")
    echo "$line" >&2
  done
}

cannot_write() {
  report "failed: cannot write $log" >&2
  exit 1
}
time_of() { stat --format=%.6Y "$1"; }
# Two makes that start at once may both find a step to be done, such as reading the recordings. Who
# comes second must not do it again: with it would be done again, next time, all that came of it. It
# is done when this very command has ended well since make looked, and no file that it names has
# changed since it began. Tables are made again, as their commands do not name their cells.
done_meanwhile() {
  local words="$*" begun word after_output=
  [[ -n ${ASKED_AT:-} && $words =~ \ --output(-dir\ |\ .*\.h5$) ]] || return
  [[ -f $log && $(head -n 1 "$log") == "$command" ]] || return
  [[ $(tail -n 1 "$log") == "step: exit 0 after "* && $(time_of "$log") > $ASKED_AT ]] || return
  begun=$(sed -n '2s/^step: begun at //p' "$log")
  for word; do
    [[ -n $after_output || ! -f $word || ! $(time_of "$word") > $begun ]] || return
    after_output=
    [[ $word != --output ]] || after_output=yes
  done
}

mkdir -p "$folder" 2>/dev/null || cannot_write
[[ ! -L $log ]] || cannot_write # a link may have been planted
{ exec 9>>"$log"; } 2>/dev/null || cannot_write
# The stage inherits the lock: should this script be killed alone, its stage is still running. Status
# code 1 says that another has it; any other that this file system has no locks, and we go without.
flock --timeout 1 9 2>/dev/null
if (($? == 1)); then
  report "waits: another make is at this step" >&2
  flock 9
fi
command="${SUBMIT:+$SUBMIT }$BIN/$stage $*"
if done_meanwhile "$@"; then
  report "done meanwhile by another make"
  exit 0
fi
{ echo "$command" >"$log" && echo "step: begun at $(time_of "$log")" >>"$log"; } 2>/dev/null || cannot_write

started=${EPOCHREALTIME/./}
exec 3> >(show_and_log)
reader=$!
# SUBMIT is a command with its options: its words are meant to be split.
# shellcheck disable=SC2086
$SUBMIT "$BIN/$stage" "$@" >>"$log" 2>&3 3>&- &
child=$!
exec 3>&-

# A signal is passed on, and the stage waited for: it may be writing a checkpoint.
signalled=1
trap 'signalled=1; kill -TERM "$child" 2>/dev/null' INT TERM HUP
while ((signalled)); do
  signalled=0
  wait "$child"
  status=$?
done
wait "$reader"

seconds=$(((${EPOCHREALTIME/./} - started) / 1000))
seconds=$((seconds / 1000)).$((seconds % 1000 / 100))
# The stage's last line says what it did; a warning or how far it was, which begin with the stage's name, may
# come behind it.
# Which stage, for which cell and in which file, stands before it already; where it gives a result after a
# colon, that is enough.
summary=$(awk -v name="$stage" 'NR > 2 && !/^step: used / {
    last = $0
    if (index($0, name ": ") != 1 && index($0, name "  ") != 1) said = $0
  }
  END { print said == "" ? last : said }' "$log")
summary=${summary#"$stage: "}
summary=${summary%%": $folder/"*}
summary=${summary#*: }
echo "step: exit $status after $seconds s" >>"$log"
case $status in
  0) fit "$(report "$(printf '%8s s  %s' "$seconds" "$summary")")" ;;
  75) report "interrupted after a checkpoint; the same command goes on from there" >&2 ;;
  *) report "failed with exit code $status after $seconds s (log: $log)" >&2 ;;
esac
exit "$status"
