#!/bin/bash
# How far a run is: the cells of every data set and method that are done, running, failed and missing,
# the failed ones by name, and an estimate of the time left. Reads only; a run may go on meanwhile.
# usage: pipeline/status.sh results/RUN MAKE VARIABLE=VALUE...
set -euo pipefail

run=$1
shift
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
# shellcheck source=jobs/common.sh
source jobs/common.sh
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

# What is to be done, make itself says, by the settings as they are now: so what an older setting has
# made counts as missing.
"$@" --dry-run list-cells cells >"$scratch/answer"
awk '$1 == "cell" { print $2 }' "$scratch/answer" >"$scratch/cells"
awk '$1 == "pipeline/step.sh" { print $2, $3 }' "$scratch/answer" >"$scratch/steps"

# Where this run was submitted to Slurm: what is in the queue, and which jobs ended otherwise than well.
jobs=$(last_submission "$run")
[[ -z $jobs ]] || jobs/ended.sh "$run" "$jobs" "$scratch"
# Why the job ended that was to make a step of this folder.
job_ended() { # folder
  local list why
  [[ -n $jobs && -s $scratch/ended ]] || return 0
  while IFS=$'\t' read -r list why; do
    ! grep -qF "$1/" "$jobs/$list" 2>/dev/null || echo "$why"
  done <"$scratch/ended" | sed -n 1p
}

# A line for each step that is to be done: folder, stage, state, and of a failed one its exit code. See
# step.sh for what the logs say.
while read -r folder stage; do
  log=$folder/$stage.log
  state=missing code=
  if [[ -f $log ]]; then
    code=$(sed -n 's/^step: exit \([0-9]*\) after .*/\1/p' "$log" | tail -n 1)
    case $code in
      0 | 75 | 129 | 130 | 131 | 138 | 143) ;; # of older settings, or stopped
      '')
        if ! flock --shared --nonblock "$log" true; then
          state=running
        elif [[ $(job_ended "$folder") ]]; then # together with its job
          state=failed
        fi
        ;;
      *) state=failed ;;
    esac
  fi
  echo "$folder $stage $state $code"
done <"$scratch/steps" >"$scratch/states"

# What steps have taken: folder, stage, seconds.
{ grep -rH --include='*.log' '^step: exit 0 after ' "$run" 2>/dev/null || true; } |
  sed -n 's|^\(.*\)/\([^/]*\)\.log:step: exit 0 after \([0-9.]*\) s$|\1 \2 \3|p' >"$scratch/durations"

awk -v run="$run" -f "${0%/*}/status.awk" \
  "$scratch/durations" "$scratch/states" "$scratch/cells"

# Of a step that says nothing itself: it was killed by the kernel or with its job, or it crashed.
why_without_a_word() { # folder, stage, exit code
  local job
  job=$(job_ended "$1")
  case $3 in
    '') echo "$2: its job ended: $job" ;;
    137) echo "$2: killed, ${job:-perhaps for want of memory} (exit code 137)" ;;
    *) echo "$2: exit code $3" ;;
  esac
}

# The steps in a state, each with the first line of its log that a pattern fits.
list() { # state, pattern (STAGE stands for the stage's name), which of the lines
  local folder stage state code log line
  grep -q " $1 " "$scratch/states" || return 0
  printf '\n%s\n' "$1"
  while read -r folder stage state code; do
    [[ $state == "$1" ]] || continue
    log=$folder/$stage.log
    line=$({ grep "${2//STAGE/$stage}" "$log" || true; } | "$3" -n 1)
    printf '  %s: %s (log: %s)\n' "${folder#"$run/"}" "${line:-$(why_without_a_word "$folder" "$stage" "$code")}" "$log"
  done <"$scratch/states"
}
list running '^STAGE  ' tail
list failed '^STAGE: ' head
[[ -z $jobs ]] || awk -F '\t' -v log_folder="$jobs" -f jobs/ended.awk "$scratch/queue" "$scratch/ended"
[[ ! -f $jobs/tables.log ]] || grep '^spent: ' "$jobs/tables.log" || true
