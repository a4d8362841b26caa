#!/bin/bash
source "${0%/*}/slurm.sh"
source "${0%/*}/../pipeline/support.sh"
source "${0%/*}/jobs.sh"
test_measure() {
  mkdir -p bin results
  ln -s "$programs"/* bin
  cp -r "$project/results/published" results
  requests >before
  date +%s >t0
  make --silent cluster BIN=bin RUN=t DATASETS=simulated-small METHODS="none smote dynamics vae ae piae-dt physics" RATIOS="100to1 25to1 10to1 5to1" SEEDS="0 1" LIBTORCH=off CORES=2 MINUTES=60
  until in_log tables.log '^job: life ended' 2>/dev/null; do sleep 2; done
  echo "requests $(($(requests) - $(<before))) in $(($(date +%s) - $(<t0))) s"
  cat results/t/.jobs/*/{records,cells.0,tables}.log | grep -E "^(job|spent)"
  cp -r results/t /tmp/wt/jobs-measure
}
slurm_up
run_tests
