#!/bin/bash
# `make cluster` on a real Slurm, with the programs themselves: the whole of a small grid.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/slurm.sh"
source "${0%/*}/../pipeline/support.sh"

# Jobs that take more memory than they asked for are killed, as by most clusters; and n4 has a GPU, or so it
# is told.
eval "$(declare -f slurm_conf | sed '1s/slurm_conf/plain_conf/')"
slurm_conf() {
  echo "Name=gpu File=/dev/null" >"$slurm_folder/gres.conf"
  plain_conf | sed '/^NodeName=n4/s/$/ Gres=gpu:1/'
  printf '%s\n' JobAcctGatherType=jobacct_gather/linux JobAcctGatherFrequency=1 \
    JobAcctGatherParams=OverMemoryKill GresTypes=gpu
}

# Programs that a test may put others in front of, settings with which all takes seconds.
small_grid() {
  mkdir -p bin results
  ln -s "$programs"/* bin
  cp -r "$project/results/published" results
  sed -i -E "s/^epochs = [0-9]+/epochs = 2/; /^\[train.piae-dt\]/,/^\[/s/^epochs = .*/epochs = ${1:-2}/" pipeline/protocol.toml
}
grid=(BIN=bin DATASETS=simulated-small METHODS="none smote piae-dt" RATIOS="100to1 10to1" SEEDS="0 1" LIBTORCH=off)
cluster() { # target of make, variables
  make --silent "$1" "${grid[@]}" RUN=t CORES=2 "${@:2}" 2>&1
}
alone() { make --silent -j2 "$1" "${grid[@]}" RUN=alone "${@:2}" >/dev/null 2>&1; }
id_of() { awk -v kind="$1" '$1 == kind { print $2 }' results/t/.jobs/*/submitted | tail -n 1; }
nothing_queued() { [[ -z $(squeue --noheader) ]]; }
until_done() { until_true "all jobs have ended" nothing_queued; }
in_log() { grep -qE -- "$2" results/t/.jobs/*/"$1"; }
# Artefacts and tables, without logs and what says when and where.
bytes_of() {
  (cd "results/$1" && find . -name .jobs -prune -o -type f ! -name '*.log' ! -name 'run.html' ! -name 'report.*' \
    ! -path '*/.settings/*' -exec sha256sum {} + | sort -k 2)
}
expect_as_alone() {
  alone "$@"
  expect_equal "$(bytes_of t)" "$(bytes_of alone)"
}

test_the_grid_in_jobs_ends_in_the_same_bytes_as_without() {
  small_grid
  local before asked output
  before=$(sdiag | awk '/^Server thread count/ { exit } { next }'; sdiag | awk '/REQUEST_/ { n += $3 } END { print n + 0 }')
  SECONDS=0
  output=$(OMP_NUM_THREADS=3 cluster cluster MINUTES=1)
  expect_line "$output" '^records +1 +2 '
  expect_line "$output" '^submitted as job .* \(records\), .* \(cells\), .* \(tables\)$'
  until_done
  asked=$(($(sdiag | awk '/REQUEST_/ { n += $3 } END { print n + 0 }') - before))
  echo "$asked requests in $SECONDS s"
  in_log tables.log '^spent: [0-9]+ steps in 3 jobs' || fail "$(cat results/t/.jobs/*/tables.log)"
  grep -h '^spent' results/t/.jobs/*/tables.log
  expect_as_alone all
  expect_line "$(cluster status)" '^all +8 +8 +0 +0 +0 '
  expect_line "$(cluster cluster-plan)" '^1 submissions'
}

slurm_up
run_tests
