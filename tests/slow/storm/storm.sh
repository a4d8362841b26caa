#!/bin/bash
# The storm: thousands of damages, attacks and accidents to a run. Each part ends with a line of counts, and fails if
# anything was not handled as SECURITY.md promises. Failures are kept with the bytes to repeat them. An interrupted
# storm continues when it is requested again.
#   kills     kill -9 to random processes of a small grid, and the same command again
#   flips     one flipped bit in an artefact
#   meanings  an artefact with other contents and correct digests
#   inputs    damaged inputs of every reader in process, with the sanitizers if built so
#   cluster   accidents on a real Slurm (tests/slow/storm/cluster.sh), if one is installed
# usage: tests/slow/storm/storm.sh FOLDER BIN INPUTS_BIN least|short|full [SEED]
#        tests/slow/storm/storm.sh FOLDER BIN INPUTS_BIN PART COUNT [SEED]
# FOLDER holds the state and the findings; BIN the programs; INPUTS_BIN those with the sanitizers.
set -uo pipefail

here=$(realpath "${BASH_SOURCE[0]%/*}")
if (($# < 4)); then
  sed -n 's/^# usage: /usage: /p' "$0" >&2
  exit 2
fi
mkdir -p "$1"
folder=$(realpath "$1") bin=$(realpath "$2") inputs_bin=$(realpath "$3")
counts() { parts=(kills "$1" flips "$2" meanings "$3" inputs "$4" cluster "$5"); }
case $4 in
  least) counts 3 22 22 400 2 ;;
  short) counts 8 300 300 10000 2 ;;
  full) counts 200 10000 2000 1000000 20 ;;
  *) parts=("$4" "${5:?how many}") && shift ;;
esac
seed=${5:-1}
# With more than two cores, leave one to the programs that a job runs.
jobs=$(nproc)

export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=1024:quarantine_size_mb=16
export UBSAN_OPTIONS=print_stacktrace=1
status=0
corpus=$folder/corpus

make_corpus() {
  [[ ! -e $corpus/made ]] || return 0
  rm -rf "$corpus"
  "$here/corpus.sh" "$corpus" "$bin" && touch "$corpus/made"
}

# Several jobs share a part, each with a folder and a seed of its own. Their last lines are summed.
in_jobs() { # part, count, the program's folder
  local job place pids=() share log failed=0
  for ((job = 0; job < jobs; ++job)); do
    place=$folder/$1-$2-$seed/$job log=$folder/$1-$2-$seed/$job.log
    share=$(($2 / jobs + (job < $2 % jobs)))
    mkdir -p "$place/reports"
    ASAN_OPTIONS=$ASAN_OPTIONS:log_path=$place/reports/report \
      UBSAN_OPTIONS=$UBSAN_OPTIONS:log_path=$place/reports/report \
      "$3/storm_$1" "$corpus/artefacts" "$place" "$share" "$seed$job" "$bin" >"$log" 2> >(tee "$log.errors" >&2) &
    pids+=($!)
  done
  for job in "${pids[@]}"; do wait "$job" || failed=1; done
  sed -nE '/^[a-z]+: [0-9]+ done/!p' "$folder/$1-$2-$seed"/*.log
  sed -nE 's/^[a-z]+: ([0-9]+) done, ([0-9]+) refused, ([0-9]+) accepted, ([0-9]+) missed$/\1 \2 \3 \4/p' \
    "$folder/$1-$2-$seed"/*.log |
    awk -v part="$1" '{ for (i = 1; i <= 4; ++i) sum[i] += $i }
      END { printf "%s: %d done, %d refused, %d accepted, %d missed", part, sum[1], sum[2], sum[3], sum[4] }'
  return $failed
}

run_part() { # part, count
  case $1 in
    kills) "$here/kills.sh" "$folder/kills" "$2" "$seed" "$bin" ;;
    flips | meanings) make_corpus && in_jobs "$1" "$2" "$bin" ;;
    inputs) make_corpus && in_jobs inputs "$2" "$inputs_bin" ;;
    cluster) PIAE_BIN=$bin "$here/cluster.sh" "$2" "$seed" ;;
    *) echo "storm: no part '$1'; the parts are kills, flips, meanings, inputs and cluster" >&2 && return 2 ;;
  esac
}

for ((i = 0; i < ${#parts[@]}; i += 2)); do
  part=${parts[i]} count=${parts[i + 1]}
  ((count > 0)) || continue
  started=$SECONDS
  said=$(run_part "$part" "$count")
  code=$?
  if ((code == 77)); then
    echo "$part: skipped: ${said##*$'\n'}"
    continue
  fi
  seconds=$((SECONDS - started))
  printf '%s, %d.%d minutes\n' "$said" $((seconds / 60)) $((seconds % 60 / 6))
  # Success: the next storm of this kind restarts.
  if ((code == 0)); then
    rm -rf "${folder:?}/$part-$count-$seed"
  else
    echo "storm: $part has failed; the findings are in $folder" >&2
    status=1
  fi
done
exit $status
