#!/bin/bash
# Which jobs of a run are in the queue, and which ended otherwise than well. Asks Slurm once, and reads the
# jobs' logs, so that it knows for ever what Slurm forgets after some minutes.
# usage: jobs/ended.sh results/RUN SUBMISSION FOLDER
# Writes FOLDER/queue, lines of jobs_in_queue, and FOLDER/ended: name of the job's list and why, with a tab
# between. Where Slurm does not answer, a log without an end may be that of a job that runs: it is not named then.
set -euo pipefail
# shellcheck source=jobs/common.sh
source "${0%/*}/common.sh"

run=$1 submission=$2 folder=$3
queue_known=yes
jobs_in_queue "$run" >"$folder/queue" 2>/dev/null || queue_known=
[[ $queue_known ]] || echo $'?\t?\tthe queue is not known here: squeue does not answer' >"$folder/queue"

for log in "$submission"/*.log; do
  [[ -f $log ]] || continue
  name=${log##*/}
  name=${name%.log}
  awk -F '\t' -v name="$name" '$2 == name { found = 1 } END { exit !found }' "$folder/queue" && continue
  awk -v name="$name" -v queue_known="$queue_known" '
    /^job: life begun at / { why = "killed" }
    /^job: life ended at / { why = $0; sub(/.*, status [0-9]+: /, "", why); if (/, status 0: /) why = "" }
    tolower($0) ~ /oom.kill|out of memory|exceeded (job )?memory limit/ { why = "out of memory" }
    /DUE TO TIME LIMIT/ { if (why != "out of memory") why = "out of time" }
    /DUE TO NODE FAILURE/ { why = "its node failed" }
    /CANCELLED AT .* \*\*\*/ && why == "killed" { why = "cancelled" }
    END { if (why != "" && (why != "killed" || queue_known)) print name "\t" why }' "$log"
done >"$folder/ended"
