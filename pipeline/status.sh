#!/bin/bash
# How far a run is: the cells of every data set and method that are done, running, failed and missing,
# the failed steps by name, and an estimate of the time left. Reads only; a run may go on meanwhile.
# usage: pipeline/status.sh results/RUN GOAL GIVEN MAKE VARIABLE=VALUE...
# Where GOAL is '', it is that of the last submission to Slurm, and without one `all`. GIVEN names the variables
# that the user gave. The others are as in the last submission, where that was of this goal.
set -euo pipefail

run=$1 goal=$2 given=$3
shift 3
make=("$@")
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
# shellcheck source=jobs/common.sh
source jobs/common.sh
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

# What stands in logs and in a submission, anybody may have written: a terminal must not obey it.
printable() { LC_ALL=C tr '\000-\010\013-\037\177' '?'; }

jobs=$(last_submission "$run")
choice=("$goal")
[[ -z $jobs ]] || mapfile -t choice < <(printable <"$jobs/choice")
[[ $goal ]] || goal=${choice[0]}
if [[ $goal == "${choice[0]}" ]]; then
  for name in DATASETS METHODS RATIOS CLASSIFIERS SEEDS; do
    value=$(value_of "$name" "${choice[@]}")
    [[ ! $value || " $given " == *" $name "* ]] || make+=("$name=$value")
  done
fi

# What is counted are cells, or what takes their place.
counted=cells made_by='score|diagnose'
case $goal in
  '' | all) goals=(tables features) ;;
  cells) goals=(cells) ;;
  sweep | contrast | readings) goals=("$goal") ;;
  identify) goals=(identify) counted=models made_by=train ;;
  *)
    echo "status: one of all, cells, sweep, contrast, identify and readings at a time, not '$goal'" >&2
    exit 2
    ;;
esac

# The steps of these goals: folder, stage, file. What is to be done, make itself says, by the settings as they
# are now; so what an older setting has made counts as missing. And it says what all of it would be.
steps() { # options of make
  "${make[@]}" only_asking=yes --dry-run "$@" "${goals[@]}" | awk -f jobs/steps.awk | cut -f 1,2,4
}
steps >"$scratch/steps"
steps --always-make | awk -F '\t' -v made_by="^($made_by)\$" '$2 ~ made_by { print $3 }' >"$scratch/cells"

# Stages that the last job of a submission runs.
tables='tabulate|sweep(@[^ ]+)?|readings|identify|contrast'

# Where this run was submitted to Slurm: what is in the queue, and which jobs ended otherwise than well.
[[ -z $jobs ]] || jobs/ended.sh "$run" "$jobs" "$scratch"
# Why the job ended that was to make this file.
job_ended() { # stage, file
  local list why
  [[ -n $jobs && -s $scratch/ended ]] || return 0
  while IFS=$'\t' read -r list why; do
    if [[ $list == tables ]]; then
      [[ ! $1 =~ ^($tables)$ ]] || echo "$why"
    else
      ! grep -qxF "$2" "$jobs/$list" 2>/dev/null || echo "$why"
    fi
  done <"$scratch/ended" | sed -n 1p
}

# Of many logs, one a line, the lines that a pattern fits: log and line. There may be a hundred thousand, so they are
# not looked at one by one.
lines_of() { # pattern
  { xargs --no-run-if-empty --delimiter='\n' grep --text --with-filename -- "$1" || true; } |
    printable | sed 's/\.log:/.log\t/'
}

# How the steps that are to be done have ended; see step.sh for what the logs say.
declare -A exit_of=()
while IFS=$'\t' read -r log code; do exit_of[$log]=$code; done < <(
  while IFS=$'\t' read -r folder stage _; do
    [[ ! -f $folder/$stage.log ]] || echo "$folder/$stage.log"
  done <"$scratch/steps" | lines_of '^step: exit [0-9]* after ' | sed -E 's/\tstep: exit ([0-9]*) .*/\t\1/'
)

# A line for each step that is to be done: folder, stage, state, file, and of a failed one its exit code.
while IFS=$'\t' read -r folder stage file; do
  log=$folder/$stage.log
  state=missing code=
  if [[ -f $log ]]; then
    code=${exit_of[$log]-}
    case $code in
      0 | 75 | 129 | 130 | 131 | 138 | 143) ;; # of older settings, or stopped
      '')
        if ! flock --shared --nonblock "$log" true; then
          state=running
        elif [[ $(job_ended "$stage" "$file") ]]; then # together with its job
          state=failed
        fi
        ;;
      *) state=failed ;;
    esac
  fi
  echo "$folder $stage $state $file $code"
done <"$scratch/steps" >"$scratch/states"

# What steps have taken: folder, stage, seconds.
mapfile -t runs < <(cut -d / -f -2 "$scratch/cells" | sort -u) # of a contrast two
{ grep -rH --include='*.log' '^step: exit 0 after ' "${runs[@]:-$run}" 2>/dev/null || true; } |
  sed -n 's|^\(.*\)/\([^/]*\)\.log:step: exit 0 after \([0-9.]*\) s$|\1 \2 \3|p' >"$scratch/durations"

# Neither features nor tables are cells, and no cell waits for them.
grep -vE "^[^ ]+ (features|$tables) " "$scratch/states" >"$scratch/counted" || true
awk -v run="$run" -v counted="$counted" -f "${0%/*}/status.awk" \
  "$scratch/durations" "$scratch/counted" "$scratch/cells" | printable

# Says why a step ended that logged no reason, or only a guess: the reason of its job, the guess, or the exit code.
why_it_ended() { # stage, file, exit code, guess
  local job
  job=$(job_ended "$1" "$2")
  [[ ! $3 || $job != "some steps failed" ]] || job=
  [[ ! $job ]] || job="$1: its job ended: $job"
  echo "${job:-${4:-$1: exit code $3}}"
}

# The steps in a state, each with the first or the last line of its log in which its program says something.
list() { # state, what comes behind the program's name, head or tail
  local folder stage state file code log line program
  local -A said=()
  grep -q " $1 " "$scratch/states" || return 0
  awk -v state="$1" -v folder="$scratch" '$3 == state {
    program = $2
    sub(/@.*/, "", program)
    print $1 "/" $2 ".log" >(folder "/logs." (program == "features" ? "diagnose" : program))
  }' "$scratch/states"
  for program in "$scratch"/logs.*; do
    while IFS=$'\t' read -r log line; do
      [[ $3 == head && ${said[$log]-} ]] || said[$log]=$line
    done < <(lines_of "^${program##*.}$2" <"$program")
    rm "$program"
  done
  printf '\n%s\n' "$1"
  while read -r folder stage state file code; do
    [[ $state == "$1" ]] || continue
    log=$folder/$stage.log
    line=${said[$log]-}
    [[ $line || $state != running ]] || line=$stage
    [[ $line && $line != *": killed, perhaps for want of memory" ]] ||
      line=$(why_it_ended "$stage" "$file" "$code" "$line")
    printf '  %s: %s (log: %s)\n' "${folder#"$run/"}" "$line" "$log"
  done <"$scratch/states"
}
{
  list running '  ' tail
  list failed ': ' head
  [[ -z $jobs ]] || awk -F '\t' -v log_folder="$jobs" -f jobs/ended.awk "$scratch/queue" "$scratch/ended"
  [[ ! -f $jobs/tables.log ]] || grep --text '^spent: ' "$jobs/tables.log" || true
} | printable
