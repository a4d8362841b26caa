#!/bin/bash
# Submits the remaining steps of a run to Slurm, for `make cluster`; or only prints them.
# usage: jobs/submit.sh [--plan] CORES=N MINUTES=N JOBS=N [GPU_PARTITION=NAME]
# The Makefile exports the request: GOALS, RUN, DATASETS, ... sbatch takes other options from its own variables:
# SBATCH_PARTITION, SBATCH_ACCOUNT, ...
set -euo pipefail

usage() { sed -n '/^# usage: /,/^[^#]/s/^# //p' "$0"; }
only_plan=
if [[ ${1:-} == --plan ]]; then
  only_plan=yes
  shift
fi
if [[ ${1:-} == --help ]]; then
  usage
  exit
elif (($# == 0)); then
  usage >&2
  exit 2
fi
cd "${0%/*}/.."
# shellcheck source=jobs/common.sh
source jobs/common.sh

goal=${GOALS:-all}
results=$(run_folder)
jobs_at_a_time=$(value_of JOBS "$@") gpu_partition=$(value_of GPU_PARTITION "$@")
for name in CORES MINUTES JOBS; do
  value=$(value_of "$name" "$@")
  [[ $value =~ ^[1-9][0-9]{0,4}$ ]] || die "$name: must be a whole number from 1 up, not '$value'"
done
if [[ $only_plan ]]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  GOALS=$goal "$BIN/plan" --looks --format jobs --jobs-folder "$scratch" --cores "$(value_of CORES "$@")" \
    --minutes "$(value_of MINUTES "$@")"
  exit
fi

# Slurm signals a job two minutes before its time limit, so that trainings write checkpoints; after half the time if the
# limit is below four minutes.
limit_s=$(seconds_of "${SBATCH_TIMELIMIT:-60}") ||
  die "SBATCH_TIMELIMIT: must be minutes, minutes:seconds, hours:minutes:seconds or days-hours, not '$SBATCH_TIMELIMIT'"
told_s=$((limit_s < 240 ? limit_s / 2 : 120))

# If others can write there, a link may have been planted, and a pipe would block.
lock=$results/.jobs/lock
[[ ! -L $results/.jobs && ! -L $lock && (! -e $lock || -f $lock) ]] ||
  die "$results/.jobs or its lock is a link or not a regular file; remove it; nothing is submitted"
# A job that cannot write its log ends without a message, so try it first.
{ mkdir -p "$results/.jobs" && exec 9>>"$lock"; } 2>/dev/null ||
  die "$results/.jobs cannot be written, but the jobs keep their logs there; nothing is submitted"
flock --nonblock 9 || die "another \`make cluster\` is submitting this run; nothing is submitted"
queue=$(jobs_in_queue "$results") || die "Slurm does not answer, see above; nothing is submitted"
[[ -z $queue ]] || die "jobs of this run are in the queue already: $(job_ids <<<"$queue")" \
  "of $(job_users <<<"$queue");" \
  "\`make status\` shows them, \`make cluster-stop\` stops them"

folder=$results/.jobs/$(date +%Y%m%dT%H%M%S)
mkdir "$folder" || die "$folder exists already; try again in a second"
GOALS=$goal "$BIN/plan" --format jobs --jobs-folder "$folder" --cores "$(value_of CORES "$@")" \
  --minutes "$(value_of MINUTES "$@")" | tee "$folder/plan.txt" || {
  status=$?
  rm -r "$folder"
  exit "$status"
}
{
  echo "$goal"
  for name in $request; do [[ ! ${!name:-} ]] || echo "$name=${!name}"; done
} >"$folder/choice"

# If a job of an array calls this script, the new jobs must not become its tasks.
unset "${!SLURM_ARRAY_@}" SBATCH_ARRAY_INX

submitted=()
submit() { # kind of job, number of them, cores, minutes, megabytes, further options of sbatch
  local kind=$1 options=() id
  if [[ $kind == cells* ]]; then
    options+=("--array=0-$(($2 - 1))%$jobs_at_a_time" --output="$folder/$kind.%a.log")
  else
    options+=(--output="$folder/$kind.log")
  fi
  # sbatch's own environment overrides the estimates.
  [[ ${SBATCH_TIMELIMIT:-} ]] || options+=(--time="$4")
  [[ ${SBATCH_MEM_PER_NODE:-}${SBATCH_MEM_PER_CPU:-} ]] || options+=(--mem="$5M")
  id=$(sbatch --parsable --job-name="$(job_name "$results" "$kind")" --chdir="$PWD" --nodes=1 --ntasks=1 \
    --cpus-per-task="$3" --requeue --open-mode=append --signal="B:USR1@$told_s" "${options[@]}" "${@:6}" \
    jobs/job.sbatch "$folder" "$kind" </dev/null) || undo "sbatch refused the job $kind, see above"
  id=${id%%;*}
  submitted+=("$id")
  printf '%s\t%s\n' "$kind" "$id" >>"$folder/submitted"
}
# Cancels everything that was submitted.
undo() {
  ((${#submitted[@]} == 0)) || scancel "${submitted[@]}"
  rm -f "$folder/submitted"
  die "$1; nothing is left in the queue"
}

after() { # sets `dependency` to wait for all jobs submitted so far
  local IFS=:
  dependency=()
  ((${#submitted[@]} == 0)) || dependency=("--dependency=afterany:${submitted[*]}")
}
dependency=()
while IFS=$'\t' read -r kind number cores minutes megabytes _; do
  [[ $kind != tables ]] || after
  further=("${dependency[@]}")
  if [[ $kind == cells-gpu ]]; then
    further+=(--gres=gpu:1 ${gpu_partition:+"--partition=$gpu_partition"})
  fi
  submit "$kind" "$number" "$cores" "$minutes" "$megabytes" "${further[@]}"
  [[ $kind != records ]] || after
done <"$folder/jobs"

echo "submitted as job $(awk -F '\t' '{ printf "%s%s (%s)", before, $2, $1; before = ", " }' "$folder/submitted")"
echo "With the same RUN, \`make status\` shows the progress and \`make cluster-stop\` stops it. Logs: $folder"
