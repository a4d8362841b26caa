#!/bin/bash
# Runs one stage for one folder of a run: a log beside what it makes, warnings and errors on
# standard error, one line when it is done. Whatever it prints begins with the cell it belongs to.
#
# The log is locked while the step runs. Its second line says when it began, by the clock of the file
# system, and its last ones how long it has waited for its turn, where it has, what the stage used, unless
# it was killed, and how it ended:
#   step: begun at 1763800000.123456
#   step: waited 20.1 s
#   step: used 11.93 s of processor time and 153 MB of memory
#   step: exit 65 after 12.3 s
# Locked and without the last line, a step is running; not locked and without it, it was killed. `make
# status` and `make report` read this.
#
# usage: pipeline/step.sh results/RUN/DATASET/... STAGE OPTION... [-- FILE...]
# The FILEs are what the stage makes, beside that which its --output says.
# From the environment: BIN (folder of the programs), SUBMIT (a command to put before the stage),
# ASKED_AT (when the step was planned; may be missing), ONLY_IF_DUE (that it is due only if what it waits for has
# come out otherwise than before), STEP_LOG (what the log is called where the stage has another step in the same
# folder; otherwise as the stage), CHECKPOINT_WITHIN (how many seconds
# to wait for the checkpoint of a stage whose launcher has given up; 30, as long as Slurm waits before it kills).
set -u
export LC_ALL=C    # numbers and times with a point
export PIAE_STEP=1 # the stage says on standard error that it has started, and what it used

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
# A stage runs on one thread: make and the scheduler fill the cores. Only simulate, which everything
# else waits for, takes what there is.
[[ $stage == simulate ]] || export OMP_NUM_THREADS=1
# shellcheck source=pipeline/outputs.sh
source "${0%/*}/outputs.sh"

# A grid has thousands of steps: no process is started here for what bash does itself. So these leave what they
# find in a variable of their name.
now() { now=$((${EPOCHREALTIME/./} / 1000)); } # ms
seconds() { seconds=$(($1 / 1000)).$(($1 % 1000 / 100)); } # of ms
# What comes in hundreds of lines is cut where a terminal ends; the log has it whole.
fit() { ((${#1} <= 100)) && fit=$1 || fit=${1:0:97}...; }
report() { printf '%-32s %-10s %s\n' "$cell" "$step" "$1"; }

show_and_log() {
  local waited=
  trap '' INT TERM HUP QUIT # it ends when the stage does
  while IFS= read -r line; do
    # Where a command stands before the stage, its job may have waited in a queue.
    if [[ $line == "step: started" && ! $waited ]]; then
      now
      waited=$((now - submitted))
      seconds $waited
      ((waited < 100)) || [[ ! $SUBMIT ]] || line="step: waited $seconds s"
    fi
    printf '%s\n' "$line" >>"$log"
    [[ $line != "step: "* ]] || continue
    printf -v line '%-32s %s' "$cell" "$line"
    # How far a stage is, is cut; a warning or an error never.
    fit=$line
    [[ $line != *" $stage  "[#.]* ]] || fit "$line"
    echo "$fit" >&2
  done
}
# Whoever signals all processes of a job at once, as Slurm does, would end a grep that looks into the log.
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
[[ ! -e $log || -f $log ]] || cannot_write # a pipe would be waited for
{ exec 9>>"$log"; } 2>/dev/null || cannot_write
# The stage inherits the lock: should this script be killed alone, its stage is still running. Status
# code 1 says that another has it; any other that this file system has no locks, and we go without.
flock --timeout 1 9 2>/dev/null
if (($? == 1)); then
  report "waits: another make is at this step" >&2
  flock 9
fi
# Another make may have done it since it was planned; or all that it waits for has come out as before.
planned_before() { [[ -s $log && ${ASKED_AT:-} && $(time_of "$log") > $ASKED_AT ]]; }
if [[ ${ONLY_IF_DUE:-} ]] || planned_before; then
  "$BIN/plan" --is-due "$name" 2>/dev/null
  if (($? == 3)); then
    report "is as it was"
    exit 0
  fi
fi
command="${SUBMIT:+$SUBMIT }$BIN/$stage ${options[*]}"
{ echo "$command" >"$log" && echo "step: begun at $(time_of "$log")" >>"$log"; } 2>/dev/null || cannot_write
note_what_is_there

now
submitted=$now
exec 3> >(show_and_log)
reader=$!
# In a process group of its own where a command stands before the stage: Ctrl-C, which a terminal sends to
# all, shall reach it by way of us alone.
[[ ! $SUBMIT ]] || set -m
# SUBMIT is a command with its options: its words are meant to be split.
# shellcheck disable=SC2086
$SUBMIT "$BIN/$stage" "${options[@]}" >>"$log" 2>&3 3>&- &
child=$!
set +m
exec 3>&-

# A signal is passed on, and the stage waited for: it may be writing a checkpoint. srun passes USR1 on, and
# kills the stage at once for any other. Before the stage has started USR1 is for nobody: TERM then takes it
# out of the queue.
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
# The stage's last line says what it did; a warning or how far it was, which begin with the stage's name, may
# come behind it.
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
# Which stage, for which cell and in which file, stands before it already; where it gives a result after a
# colon, that is enough.
summary=${summary:-$last}
summary=${summary#"$stage: "}
summary=${summary%%": $folder/"*}
summary=${summary#*: }

# srun gives up a few seconds after a requeue of its job. Then it returns 0 or 1, although the stage may still be
# writing its checkpoint, or has ended with 75 already. So the checkpoint decides, and not how srun ended.
if [[ $SUBMIT ]] && has_started && { ((status == 0)) || [[ $stopped ]]; } && ((status != 75)) && left_checkpoint; then
  status=75
fi

# That a step is done, its files say: srun of Slurm 22 returns 0 when its node is lost.
why=
if ((status == 0)) && ! made_anew; then
  status=$((${#stopped} ? 143 : 1))
  why="the stage ended as if all were well, but has not made ${missing_output:-anything}; was its node lost?"
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
  75) report "interrupted after a checkpoint; the same command goes on from there" >&2 ;;
  *) report "failed with exit code $status after $seconds s${why:+: $why} (log: $log)" >&2 ;;
esac
exit "$status"
