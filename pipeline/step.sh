#!/bin/bash
# Runs one stage for one folder of a run. Writes a log next to its files, warnings and errors to standard error, and one
# line when it is done. All output starts with the cell.
#
# The log is locked while the step runs. Its second line has the start time, by the clock of the file system. Its last
# lines have the time spent in a queue, if any, the resources used, unless the stage was killed, and the end:
#   `step: started at 1763800000.123456`
#   `step: waited 20.1 s`
#   `step: used 11.93 s of processor time and 153 MB of memory`
#   `step: exit 65 after 12.3 s`
# A locked log without the last line belongs to a running step; an unlocked one to a killed step. `make status` and
# `make report` read this.
#
# usage: pipeline/step.sh results/RUN/DATASET/... STAGE OPTION... [-- FILE...]
# The FILEs are outputs of the stage in addition to its --output.
# Environment: BIN (folder of the programs), SUBMIT (a command to put before the stage), PLANNED_AT (when the step was
# planned; optional), ONLY_IF_DUE (run only if a step that it needs has changed its outputs), STEP_LOG (name of the log
# if the stage has another step in the same folder; default: the stage), CHECKPOINT_WITHIN (seconds to wait for the
# checkpoint of a stage whose launcher has given up; default 30, as long as Slurm waits before it kills).
set -u
export LC_ALL=C    # decimal points in numbers and times
export PIAE_STEP=1 # the stage reports its start and its usage on standard error

folder=$1 stage=$2
shift 2
options=() makes=()
while (($#)); do
  [[ $1 != -- ]] || { makes+=("${@:2}") && break; }
  [[ $1 != --output ]] || makes+=("$2")
  options+=("$1")
  shift
done
cell=${folder#results/*/}
step=${STEP_LOG:-$stage}
name=$folder/$step
log=$name.log
PIAE_RUN=${folder#results/}
export PIAE_RUN=results/${PIAE_RUN%%/*} # its journal gets a line for each artefact
# shellcheck source=pipeline/environment.sh
source "${0%/*}/environment.sh"
# A stage runs on one thread, since make and the scheduler fill the cores. Only simulate, for which everything else
# waits, uses all cores.
[[ $stage == simulate ]] || export OMP_NUM_THREADS=1
# shellcheck source=pipeline/outputs.sh
source "${0%/*}/outputs.sh"

# Avoid subprocesses, since a grid has thousands of steps: each helper returns its result in the variable of the same
# name.
now() { now=$((${EPOCHREALTIME/./} / 1000)); } # ms
seconds() { seconds=$(($1 / 1000)).$(($1 % 1000 / 100)); } # of ms
# Cuts a line at the width of a terminal, since a run prints hundreds of them; the log has it whole.
fit() { ((${#1} <= 100)) && fit=$1 || fit=${1:0:97}...; }
report() { printf '%-32s %-10s %s\n' "$cell" "$step" "$1"; }

show_and_log() {
  local waited=
  trap '' INT TERM HUP QUIT # ends with the stage
  while IFS= read -r line; do
    # If a command precedes the stage, its job may have waited in a queue.
    if [[ $line == "step: started" && ! $waited ]]; then
      now
      waited=$((now - submitted))
      seconds $waited
      ((waited < 100)) || [[ ! $SUBMIT ]] || line="step: waited $seconds s"
    fi
    printf '%s\n' "$line" >>"$log"
    [[ $line != "step: "* ]] || continue
    printf -v line '%-32s %s' "$cell" "$line"
    # Progress is cut; warnings and errors are not.
    fit=$line
    [[ $line != *" $stage  "[#.]* ]] || fit "$line"
    echo "$fit" >&2
  done
}
# No grep here: a signal to all processes of the job, as Slurm sends it, would end it.
log_has() { # extended regular expression, for a line
  local line lines
  mapfile -t lines <"$log"
  for line in "${lines[@]}"; do [[ ! $line =~ $1 ]] || return 0; done
  return 1
}
has_started() { log_has '^step: (started|waited .* s)$'; }

cannot_write() {
  report "failed: cannot write $log" >&2
  exit 1
}

[[ -d $folder ]] || mkdir -p "$folder" 2>/dev/null || cannot_write
[[ ! -L $log ]] || cannot_write           # a link may have been planted
[[ ! -e $log || -f $log ]] || cannot_write # a pipe would block
{ exec 9>>"$log"; } 2>/dev/null || cannot_write
# The stage inherits the lock, because it keeps running if this script alone is killed. Status 1 means that another
# process has the lock; any other failure that the file system lacks locks, and the step runs without one.
flock --timeout 1 9 2>/dev/null
if (($? == 1)); then
  report "waits: another make runs this step" >&2
  flock 9
fi
# Another make may have finished this step since it was planned, or its inputs may have come out unchanged.
planned_before() { [[ -s $log && ${PLANNED_AT:-} && $(time_of "$log") > $PLANNED_AT ]]; }
if [[ ${ONLY_IF_DUE:-} ]] || planned_before; then
  "$BIN/plan" --is-due "$name" 2>/dev/null
  if (($? == 3)); then
    report "is unchanged"
    exit 0
  fi
fi
command="${SUBMIT:+$SUBMIT }$BIN/$stage ${options[*]}"
{ echo "$command" >"$log" && echo "step: started at $(time_of "$log")" >>"$log"; } 2>/dev/null || cannot_write
note_what_is_there

now
submitted=$now
exec 3> >(show_and_log)
reader=$!
# If a command precedes the stage, it gets a process group of its own, so that Ctrl-C, which a terminal sends to the
# whole group, reaches it only through this script.
[[ ! $SUBMIT ]] || set -m
# SUBMIT is a command with options, so its words must be split.
# shellcheck disable=SC2086
$SUBMIT "$BIN/$stage" "${options[@]}" >>"$log" 2>&3 3>&- &
child=$!
set +m
exec 3>&-

# Pass a signal on and wait for the stage, which may be writing a checkpoint. srun passes USR1 on, and kills the stage
# at once for any other signal. Before the stage has started, USR1 has no effect, so TERM takes the job out of the
# queue.
# shellcheck disable=SC2317 # the trap calls it
stop_it() {
  stopped=yes signalled=1
  if [[ $SUBMIT ]] && has_started; then
    kill -USR1 "$child" 2>/dev/null
  else
    kill -TERM "$child" 2>/dev/null
  fi
}
signalled=1 stopped=
trap stop_it INT TERM HUP QUIT
while ((signalled)); do
  signalled=0
  wait "$child"
  status=$?
done
trap 'stopped=yes' INT TERM HUP QUIT # the child has ended: another process may have its id
wait "$reader"
now
elapsed=$((now - submitted))
mapfile -t lines <"$log"
# The stage's last line is its summary. A warning or a line of progress, which starts with the stage's name, may follow
# it.
waited=0 last='' summary=''
for line in "${lines[@]:2}"; do
  if [[ $line == "step: "* ]]; then
    [[ ! $line =~ ^"step: waited "([0-9]+)\.([0-9])" s"$ ]] || waited=${BASH_REMATCH[1]}${BASH_REMATCH[2]}00
    continue
  fi
  last=$line
  [[ $line == "$stage: "* || $line == "$stage  "* ]] || summary=$line
done
seconds $((elapsed - 10#$waited))
# Stage, cell and file are already in the line, so drop them. Of a summary with a colon keep only the part after it.
summary=${summary:-$last}
summary=${summary#"$stage: "}
summary=${summary%%": $folder/"*}
summary=${summary#*: }

# srun gives up a few seconds after a requeue of its job. Then it returns 0 or 1, although the stage may still be
# writing its checkpoint, or has already ended with 75. So the checkpoint counts, not srun's exit code.
if [[ $SUBMIT ]] && has_started && { ((status == 0)) || [[ $stopped ]]; } && ((status != 75)) && left_checkpoint; then
  status=75
fi

# The outputs decide if a step is done: srun of Slurm 22 returns 0 when its node is lost.
why=
if ((status == 0)) && ! made_anew; then
  status=$((${#stopped} ? 143 : 1))
  why="the stage exited with 0, but did not make ${missing_output:-anything}; was its node lost?"
elif [[ $stopped ]] && ((status != 75)) && { ((status >= 128)) || ! has_started; }; then
  status=143
elif ((status == 137)) || { ((status)) && log_has 'oom.kill'; }; then
  why="killed, perhaps for want of memory"
fi
[[ ! $why ]] || echo "$stage: $why" >>"$log"
echo "step: exit $status after $seconds s" >>"$log"
case $status in
  0)
    printf -v line '%-32s %-10s %8s s  %s' "$cell" "$step" "$seconds" "$summary"
    fit "$line"
    echo "$fit"
    ;;
  75) report "interrupted after a checkpoint; the same command continues" >&2 ;;
  *) report "failed with exit code $status after $seconds s${why:+: $why} (log: $log)" >&2 ;;
esac
exit "$status"
