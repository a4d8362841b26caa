# shellcheck shell=bash
# What the scripts of jobs/ share; to be sourced in the folder of the project.

die() {
  echo "cluster: $*" >&2
  exit 1
}

# Of NAME=VALUE words, the value of one.
value_of() { # name, words...
  local word
  for word in "${@:2}"; do [[ $word != "$1="* ]] || echo "${word#*=}"; done
}

# What Slurm calls the jobs of a run. Another folder may have a run of that name: so the folder that a job
# works in counts, too.
job_name() { echo "piae-dt:$1:$2"; } # results/RUN, kind of job

# The jobs of a run that are in the queue, each task of an array for itself, by one request: id, kind (with
# the task behind a point), state and reason, with tabs between them.
jobs_in_queue() { # results/RUN
  local lines
  lines=$(squeue --me --array --noheader --format=$'%i\t%j\t%T\t%r\t%Z') || return
  awk -F '\t' -v OFS='\t' -v prefix="$(job_name "$1" "")" -v folder="$PWD" '
    index($2, prefix) == 1 && $5 == folder {
      kind = substr($2, length(prefix) + 1)
      if (split($1, id, "_") > 1) kind = kind "." id[2]
      print $1, kind, $3, $4
    }' <<<"$lines"
}
job_ids() { cut -f 1 | sed 's/_.*//' | sort -rnu | xargs; }

# The folder of the last submission: what each job makes, their logs. The names are times, so that the last
# is the latest.
last_submission() { # results/RUN
  local folder last=
  for folder in "$1"/.jobs/*/; do [[ ! -e $folder/submitted ]] || last=${folder%/}; done
  echo "$last"
}
