#!/bin/bash
# Runs the grid on a SLURM cluster: builds and reads the data sets here, on the login node, then
# submits one job for each seed and, after all of them, one for the tables.
#
#   jobs/submit.sh RUN=paper DATASETS=cwru SEEDS="0 1 2" DATA_DIR=/scratch/recordings
#
# Arguments are make's variables (`make help`); ARCH=x86-64-v3 suits a cluster of mixed processors.
# Options for sbatch come from its own environment variables: SBATCH_PARTITION, SBATCH_ACCOUNT, ...
set -euo pipefail
cd "$(dirname "$0")/.."

# shellcheck disable=SC2016
seeds=$(make --silent --eval 'print-seeds: ; @echo $(SEEDS)' print-seeds "$@" | tr ' ' ,)
make --silent records "$@"
mkdir -p results/.jobs

cells=$(sbatch --parsable --array="$seeds" jobs/seed.sbatch "$@")
tables=$(sbatch --parsable --dependency="afterok:${cells%%;*}" jobs/tables.sbatch "$@")
echo "submitted: cells of seeds $seeds as job ${cells%%;*}, tables as job ${tables%%;*};" \
  "their output is in results/.jobs/"
