#!/bin/bash
# Stops the jobs of a run, for `make cluster-stop`: removes waiting jobs from the queue and ends running ones, trainings
# with a checkpoint. Waits until all have ended.
# usage: jobs/stop.sh results/RUN
set -euo pipefail
cd "${0%/*}/.."
# shellcheck source=jobs/common.sh
source jobs/common.sh

results=$1
queue=$(jobs_in_queue "$results") || die "Slurm does not answer, see above; nothing is stopped"
if [[ ! $queue ]]; then
  echo "no job of $results is in the queue"
  exit
fi
read -ra jobs < <(job_ids <<<"$queue")
# Last job first: otherwise the tables would start when nothing is left to wait for.
scancel "${jobs[@]}" || die "some jobs could not be stopped; they belong to" \
  "$(job_users <<<"$queue")"
for _ in {1..60}; do
  answered=
  queue=$(jobs_in_queue "$results") && answered=yes && [[ ! $queue ]] && break
  sleep 2
done
[[ $answered ]] || die "Slurm does not answer, see above; job ${jobs[*]} may still be ending"
[[ ! $queue ]] || die "still ending: $(job_ids <<<"$queue")"
echo "stopped: job ${jobs[*]}; the same \`make cluster\` continues"
