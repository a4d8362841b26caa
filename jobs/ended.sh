#!/bin/bash
# Lists the jobs of the last submission of a run that are in the queue, and those that failed. Asks Slurm once, and
# reads the logs of the jobs, because Slurm forgets a job after some minutes.
# usage: jobs/ended.sh results/RUN
# Prints lines with tabs between the words, for `status`: "submission FOLDER", "queue KIND STATE REASON" and
# "ended JOB WHY"; nothing where nothing was submitted. Where Slurm does not answer, a log without an end may be that of
# a job that runs: it is not named then.
set -euo pipefail
# shellcheck source=jobs/common.sh
source "${0%/*}/common.sh"

run=$1
submission=$(last_submission "$run")
[[ $submission ]] || exit 0
printf 'submission\t%s\n' "$submission"
queue_known=yes
queue=$(jobs_in_queue "$run" 2>/dev/null) || queue_known=
if [[ $queue_known ]]; then
  [[ ! $queue ]] || cut -f 2-4 <<<"$queue" | sed 's/^/queue\t/'
else
  printf 'queue\t?\t?\tthe queue is not known here: squeue does not answer\n'
fi

for log in "$submission"/*.log; do
  [[ -f $log ]] || continue
  name=${log##*/}
  name=${name%.log}
  ! cut -f 2 <<<"$queue" | grep -qxF "$name" || continue
  awk -v name="$name" -v queue_known="$queue_known" '
    /^job: life begun at / { why = "killed" }
    /^job: life ended at / { why = $0; sub(/.*, status [0-9]+: /, "", why); if (/, status 0: /) why = "" }
    tolower($0) ~ /oom.kill|out of memory|exceeded (job )?memory limit/ { why = "out of memory" }
    /DUE TO TIME LIMIT/ { if (why != "out of memory") why = "out of time" }
    /DUE TO NODE FAILURE/ { why = "its node failed" }
    /CANCELLED AT .* \*\*\*/ && why == "killed" { why = "cancelled" }
    END { if (why != "" && (why != "killed" || queue_known)) print "ended\t" name "\t" why }' "$log"
done
