#!/bin/bash
# Prints the last submission of a run and its queued jobs, for `status`, separated by tabs: "submission FOLDER", "queue
# KIND STATE REASON". Prints nothing if nothing was submitted.
# usage: jobs/queue.sh results/RUN
set -euo pipefail
# shellcheck source=jobs/common.sh
source "${0%/*}/common.sh"

submission=$(last_submission "$1")
[[ $submission ]] || exit 0
printf 'submission\t%s\n' "$submission"
if queue=$(jobs_in_queue "$1" 2>/dev/null); then
  [[ ! $queue ]] || cut -f 2-4 <<<"$queue" | sed 's/^/queue\t/'
else
  printf 'queue\t?\t?\tthe queue is not known here: squeue does not answer\n'
fi
