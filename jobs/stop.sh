#!/bin/bash
# Stops the jobs of a run, for `make cluster-stop`: what waits leaves the queue, and what runs is told to end,
# trainings with a checkpoint. Waits until it has.
# usage: jobs/stop.sh results/RUN
set -euo pipefail
cd "${0%/*}/.."
# shellcheck source=jobs/common.sh
source jobs/common.sh

results=$1
queue() { jobs_in_queue "$results" || die "Slurm does not answer, see above"; }
read -ra jobs < <(queue | job_ids)
if ((${#jobs[@]} == 0)); then
  echo "no job of $results is in the queue"
  exit
fi
# The last first: the tables, which would otherwise begin when there is nothing left to wait for.
scancel "${jobs[@]}"
for _ in {1..60}; do
  left=$(queue | job_ids)
  [[ $left ]] || break
  sleep 2
done
[[ ! $left ]] || die "still ending: $left"
echo "stopped: job ${jobs[*]}; the same \`make cluster\` makes what is missing"
