#!/bin/bash
# What steps take, from the logs of runs: seconds of processor time (the mean) and megabytes (the most), by
# stage, data set, method, ratio and classifier. It is what `make cluster` divides a grid by (jobs/plan.awk).
# usage: jobs/costs.sh results/RUN... >jobs/costs.csv
set -euo pipefail
export LC_ALL=C

echo 'stage,dataset,method,classifier,ratio,seconds,megabytes'
find "$@" -name '*.log' -not -path '*/.jobs/*' -not -path '*/seed*/sweep/*' -not -path '*/seed*/sweep@*/*' -not -path '*/seed*/readings/*' \
  -exec awk -v OFS='\t' '
    /^step: used / { seconds = $3; megabytes = $9 }
    /^step: exit / {
      if ($3 == 0 && seconds != "") print FILENAME, seconds, megabytes
      seconds = ""
    }' {} + |
  awk -F '\t' '
    { depth = split($1, place, "/")
      stage = place[depth]
      sub(/\.log$/, "", stage)
      # .../DATASET/seedK/METHOD/RATIO/CLASSIFIER/STAGE.log, or less of it.
      for (i = depth - 1; i > 0 && place[i] !~ /^seed[0-9]+$/; --i) continue
      dataset = i ? place[i - 1] : place[depth - 1]
      method = i && i + 1 < depth ? place[i + 1] : ""
      ratio = i && i + 2 < depth ? place[i + 2] : ""
      classifier = i && i + 3 < depth ? place[i + 3] : ""
      key = stage "," dataset "," method "," classifier "," ratio
      sum[key] += $2
      ++count[key]
      if ($3 > most[key]) most[key] = $3 }
    END { for (key in sum) printf "%s,%.2f,%d\n", key, sum[key] / count[key], most[key] }' |
  grep -v '^features,' | sort
