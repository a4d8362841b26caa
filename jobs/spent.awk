# What the jobs of one submission have spent, from their logs (jobs/job.sbatch).
# usage: awk -f jobs/spent.awk -v submitted=SECONDS -v now=SECONDS -v steps=N FOLDER/*.log

function hours(seconds) { return sprintf("%.2f", seconds / 3600) }
function minutes(seconds) {
  return seconds < 120 ? sprintf("%d s", seconds) : sprintf("%.0f min", seconds / 60)
}

# A life that was killed has no end: it counts no time, but is counted.
function close_life(end) {
  if (begun == "") return
  if (end == "") ++killed
  else {
    allocated += (end - begun) * cores
    intervals[++interval_count] = begun " " end
  }
  begun = ""
}

FNR == 1 { close_life(FILENAME_before ~ /tables\.log$/ ? now : ""); FILENAME_before = FILENAME; ++jobs }
/^job: life begun at / { close_life(""); begun = $5; cores = $(NF - 1); ++lives }
/^job: life ended at / { used += $7; close_life($5 + 0) }

END {
  close_life(FILENAME_before ~ /tables\.log$/ ? now : "")
  # Few intervals: sorted by insertion.
  for (i = 2; i <= interval_count; ++i)
    for (k = i; k > 1 && intervals[k] + 0 < intervals[k - 1] + 0; --k) {
      swap = intervals[k]; intervals[k] = intervals[k - 1]; intervals[k - 1] = swap
    }
  until = submitted
  for (i = 1; i <= interval_count; ++i) {
    split(intervals[i], at, " ")
    if (at[1] > until) idle += at[1] - until
    if (at[2] > until) until = at[2]
  }
  printf "spent: %d steps in %d jobs; %s core-hours used of %s allocated (%.0f %%); %s from submission to " \
    "end, of which %s in the queue alone\n", steps, jobs, hours(used), hours(allocated), \
    allocated ? 100 * used / allocated : 0, minutes(now - submitted), minutes(idle)
  if (lives > jobs) printf "spent: %d jobs began again (out of time, or a node was lost)\n", lives - jobs
  if (killed) printf "spent: %d lives were killed, whose time is not counted\n", killed
}
