# shellcheck shell=bash
# Functions shared by the scripts of jobs/; to be sourced in the folder of the project.

die() {
  echo "cluster: $*" >&2
  exit 1
}

# Variables of a request, as the Makefile exports them.
request='RUN DATASETS METHODS RATIOS CLASSIFIERS SEEDS PROTOCOL DATA_DIR BIN SUBMIT'

# Prints the folder of the requested run.
run_folder() { echo "results/$RUN$([[ ${PROTOCOL:-} != blocked ]] || echo -blocked)"; }

# Sets these variables, and GOALS, as they were at a submission.
take_choice() { # folder of the submission
  local name line
  for name in $request; do export "$name="; done
  {
    read -r GOALS
    while IFS= read -r line; do export "${line?}"; done
  } <"$1/choice"
  export GOALS
}

# Prints the value of one of several NAME=VALUE words.
value_of() { # name, words...
  local word
  for word in "${@:2}"; do [[ $word != "$1="* ]] || echo "${word#*=}"; done
}

# Converts a time in sbatch's format to seconds.
seconds_of() { # [days-]hours:minutes:seconds, or less of it
  [[ $1 =~ ^(([0-9]+)-)?([0-9]+)(:([0-9]+))?(:([0-9]+))?$ ]] || return
  local days=${BASH_REMATCH[2]} first=${BASH_REMATCH[3]} second=${BASH_REMATCH[5]} third=${BASH_REMATCH[7]}
  if [[ $days || $third ]]; then
    echo $((((10#${days:-0} * 24 + 10#$first) * 60 + 10#${second:-0}) * 60 + 10#${third:-0}))
  else
    echo $((10#$first * 60 + 10#${second:-0}))
  fi
}

# Returns Slurm's name for the jobs of a run. Another folder may have a run of the same name, so the working folder of a
# job is compared, too.
job_name() { echo "piae-dt:$1:$2"; } # results/RUN, kind of job

# Lists the queued jobs of a run, of all users, each task of an array separately, by a single request: id, kind (with a
# dot and the task), state, reason and user, separated by tabs.
jobs_in_queue() { # results/RUN
  local prefix names lines id name state reason user folder
  prefix=$(job_name "$1" "")
  names=${prefix}records,${prefix}cells,${prefix}cells-gpu,${prefix}tables
  # some of squeue's own variables would hide jobs
  lines=$(unset "${!SQUEUE_@}" && squeue --name="$names" --array --noheader \
    --format=$'%i\t%j\t%T\t%r\t%u\t%Z') || return
  while IFS=$'\t' read -r id name state reason user folder; do
    # a folder may have several names
    [[ $folder -ef . ]] || continue
    [[ $id != *_* ]] || name+=.${id#*_}
    printf '%s\t%s\t%s\t%s\t%s\n' "$id" "${name#"$prefix"}" "$state" "$reason" "$user"
  done <<<"$lines"
}
job_users() { cut -f 5 | sort -u | xargs; }
job_ids() { cut -f 1 | sed 's/_.*//' | sort -rnu | xargs; }

# Prints the folder of the last submission, which has lists of the files of each job, and logs. The names are times, so
# the last one is the latest.
last_submission() { # results/RUN
  local folder last=
  for folder in "$1"/.jobs/*/; do [[ ! -e $folder/submitted ]] || last=${folder%/}; done
  echo "$last"
}
