#!/bin/bash
# Names the compilation units of the last build that cost more than four times the median, in seconds a file for units
# of several files, and in seconds for units of one file. Such a unit may include or instantiate more than it needs,
# which slows every build. These are notes, not findings, because times depend on the load of the machine.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

log=build/.ninja_log
[[ -f $log ]] || skip "because nothing was built with ninja; run \`make build\`"

# Lists the units of several files with their number of files. All other objects have one file.
files_of_units() {
  local unit
  find build -path '*/Unity/*.cxx' | while read -r unit; do
    echo "${unit#build/}.o $(grep -c '^#include' "$unit")"
  done
}

# Units below 8 s are not worth a change.
awk -v at_least=8 '
  FNR == NR { files[$1] = $2; next }
  $4 ~ /\.o$/ { seconds[$4] = ($2 - $1) / 1000 }
  function median_of(shared,    unit, sorted, n, i, j, kept) {
    for (unit in cost) if ((unit in files) == shared) sorted[++n] = cost[unit]
    for (i = 2; i <= n; ++i)
      for (j = i; j > 1 && sorted[j] < sorted[j - 1]; --j) { kept = sorted[j]; sorted[j] = sorted[j - 1]; sorted[j - 1] = kept }
    return sorted[int((n + 1) / 2)]
  }
  END {
    for (unit in seconds) cost[unit] = seconds[unit] / (unit in files ? files[unit] : 1)
    median[0] = median_of(0)
    median[1] = median_of(1)
    for (unit in cost) {
      shared = unit in files
      if (cost[unit] <= 4 * median[shared] || seconds[unit] < at_least) continue
      name = unit
      sub(/.*\.dir\//, "", name)
      printf "%s takes %.1f s%s, the median %.1f s; include and instantiate less in it\n", \
        name, cost[unit], shared ? " a file" : "", median[shared]
    }
  }' <(files_of_units) "$log" | while read -r note; do say "$note"; done
