#!/bin/bash
# Names the compilation units of the last build that cost more than four times the median, in seconds for each file of the
# library in them. Such a unit may include or instantiate more than it needs, and everybody who builds waits for it. These
# are notes, not findings, because a time depends on what else the machine did.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

log=build/.ninja_log
[[ -f $log ]] || skip "as nothing was built with ninja; \`make build\` does"

# Each unit of several files and how many it has. A file that is compiled alone pays for all its headers, so its time says
# nothing.
files_of_units() {
  local unit
  for unit in build/CMakeFiles/piae*.dir/Unity/*.cxx; do
    [[ ! -f $unit ]] || echo "${unit#build/}.o $(grep -c '^#include' "$unit")"
  done
}

# A unit that takes less than 8 s is not worth a change.
awk -v at_least=8 '
  FNR == NR { files[$1] = $2; next }
  $4 in files { seconds[$4] = ($2 - $1) / 1000 }
  END {
    for (unit in seconds) {
      cost[unit] = seconds[unit] / files[unit]
      sorted[++units] = cost[unit]
    }
    for (i = 2; i <= units; ++i)
      for (j = i; j > 1 && sorted[j] < sorted[j - 1]; --j) { kept = sorted[j]; sorted[j] = sorted[j - 1]; sorted[j - 1] = kept }
    median = sorted[int((units + 1) / 2)]
    for (unit in cost) {
      if (cost[unit] <= 4 * median || seconds[unit] < at_least) continue
      name = unit
      sub(/.*\/unity_/, "", name)
      sub(/_cxx\.cxx\.o$/, "", name)
      printf "%s takes %.1f s a file, the median %.1f s; include and instantiate less in it\n", name, cost[unit], median
    }
  }' <(files_of_units) "$log" | while read -r note; do say "$note"; done
