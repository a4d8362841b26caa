#!/bin/bash
# The cluster scripts, with a SLURM of a few lines that runs jobs at once.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

slurm() {
  mkdir path
  cat >path/sbatch <<'SBATCH'
#!/bin/bash
echo "sbatch $*" >>submitted
while [[ $1 == --* ]]; do
  [[ $1 == --array=* ]] && indices=${1#--array=}
  shift
done
for index in ${indices//,/ }; do
  SLURM_ARRAY_TASK_ID=$index SLURM_CPUS_PER_TASK=2 SLURM_JOB_ID=7 bash "$@" >/dev/null || exit
done
[[ $indices ]] || bash "$@" >/dev/null || exit
echo 7
SBATCH
  cat >path/srun <<'SRUN'
#!/bin/bash
echo srun >>submitted
while [[ $1 == --* ]]; do shift; done
exec "$@"
SRUN
  printf '#!/bin/bash\necho "scontrol $*" >>submitted\n' >path/scontrol
  chmod +x path/*
  PATH=$PWD/path:$PATH
  rm -f pipeline/datasets/*
  echo 'name = "real"' >pipeline/datasets/real.toml
  # Neither is there a compiler here, nor a need for one.
  mkdir build
  cp -r fake build/bin
  rm pipeline/build.sh pipeline/deps.sh
  ln -s /bin/true pipeline/build.sh
  ln -s /bin/true pipeline/deps.sh
}

test_a_job_for_each_seed_and_one_for_the_tables() {
  slurm
  jobs/submit.sh RUN=t DATASETS=real METHODS="none piae-dt" RATIOS="100to1 10to1" SEEDS="0 3" >messages
  expect_line "$(<messages)" "cells of seeds 0,3 as job 7, tables as job 7"
  expect_equal "$(<submitted)" "$(printf '%s\n' \
    'sbatch --parsable --array=0,3 jobs/seed.sbatch RUN=t DATASETS=real METHODS=none piae-dt RATIOS=100to1 10to1 SEEDS=0 3' \
    'sbatch --parsable --dependency=afterok:7 jobs/tables.sbatch RUN=t DATASETS=real METHODS=none piae-dt RATIOS=100to1 10to1 SEEDS=0 3')"
  expect_equal "$(awk '{ print $1 }' calls | sort | uniq -c | xargs)" \
    "4 diagnose 2 features 2 generate 1 ingest 2 score 2 split 1 tabulate 2 train"
  expect_line "$(<results/t/real/accuracy.csv)" "--seeds 0 3 "
}

test_a_job_for_each_step() {
  slurm
  make --silent all RUN=t DATASETS=real RATIOS=10to1 METHODS=piae-dt SEEDS=0 SUBMIT="srun --mem=2G" >/dev/null
  # The ninth are the figures, whose stand-in leaves no call.
  expect_equal "$(wc -l <calls) $(grep -c srun submitted)" "8 9"
}

test_a_job_out_of_time_goes_back_into_the_queue() {
  slurm
  rm build/bin/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\ntrap "touch saved; exit 75" TERM\ntouch started\nwhile :; do sleep 0.05; done\n' >build/bin/train
  chmod +x build/bin/train
  export SLURM_ARRAY_TASK_ID=0 SLURM_JOB_ID=7
  bash jobs/seed.sbatch DATASETS=real METHODS=piae-dt >/dev/null 2>&1 &
  wait_for started
  kill -TERM $!
  expect_exit 0 wait $!
  expect_equal "$(<submitted)" "scontrol requeue 7"
  [[ -e saved ]] || fail "the stage was not stopped"
}

run_tests
