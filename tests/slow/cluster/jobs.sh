# shellcheck shell=bash
# shellcheck disable=SC2154 # slurm.sh and support.sh set them
# Sourced by the tests of `make cluster`, after slurm.sh and support.sh: a Slurm with little memory on its nodes, a
# small grid, and checks of its jobs.

# Jobs that exceed their requested memory are killed, as on most clusters. n4 claims to have a GPU.
eval "$(declare -f slurm_conf | sed '1s/slurm_conf/plain_conf/')"
slurm_conf() {
  echo "Name=gpu File=/dev/null" >"$slurm_folder/gres.conf"
  plain_conf | sed '/^NodeName=n4/s/$/ Gres=gpu:1/'
  printf '%s\n' JobAcctGatherType=jobacct_gather/linux JobAcctGatherFrequency=1 \
    JobAcctGatherParams=OverMemoryKill GresTypes=gpu
}

# Lays out programs that a test may wrap, and settings with which everything takes seconds.
small_grid() { # epochs of piae-dt
  mkdir -p bin
  ln -s "$programs"/* bin
  sed -i -E "s/^epochs = [0-9]+/epochs = 2/; /^\[train.piae-dt\]/,/^\[/s/^epochs = .*/epochs = $1/" \
    pipeline/protocol.toml
}
grid=(BIN=bin DATASETS=simulated-small METHODS="none smote piae-dt" RATIOS="100to1 10to1" SEEDS="0 1"
  LIBTORCH=off)
cluster() { # target of make, variables
  make --silent "$1" "${grid[@]}" RUN=t CORES=2 "${@:2}" 2>&1
}
# Makes the same without jobs, into results/alone. A script computes each grid once, and its later tests copy it.
alone() { # target of make, variables
  local finished
  finished=$slurm_folder/alone-$({ cat pipeline/protocol.toml && echo "${grid[@]}" "$@"; } | md5sum | cut -c -32)
  if [[ ! -d $finished ]]; then
    make --silent -j2 "$1" "${grid[@]}" RUN=alone "${@:2}" >/dev/null 2>&1
    cp -r --preserve=timestamps results/alone "$finished"
  else
    cp -r --preserve=timestamps "$finished" results/alone
  fi
}
id_of() { awk -v kind="$1" '$1 == kind { print $2 }' results/t/.jobs/*/submitted | tail -n 1; }
nothing_queued() { [[ -z $(squeue --noheader) ]]; }
until_done() {
  until_true "all jobs have ended" nothing_queued || {
    tail -n 20 results/t/.jobs/*/*.log "$slurm_folder"/slurmd-*.log >&2
    return 1
  }
}
in_log() { grep -qE -- "$2" results/t/.jobs/*/"$1"; }
# Prints artefacts and tables, without logs and anything that depends on time or place.
bytes_of() {
  (cd "results/$1" && find . -name .jobs -prune -o -type f ! -name '*.log' ! -name 'run.html' ! -name 'report.*' \
    ! -name .journal ! -path '*/.settings/*' -exec sha256sum {} + | sort -k 2)
}
expect_as_alone() {
  alone "$@"
  bytes_of t >bytes_of_jobs
  bytes_of alone >bytes_alone
  expect_equal "$(diff bytes_of_jobs bytes_alone)" ""
}

# Does not query Slurm, because tests count its requests.
wait_for_line() { # log of a job, pattern
  local tries=0
  until in_log "$1" "$2" 2>/dev/null; do
    sleep 0.2
    ((++tries < 900)) || fail "no line like '$2' in $1:"$'\n'"$(cat results/t/.jobs/*/*.log)"
  done
}
expect_in_log() { # log of a job, pattern
  in_log "$@" || fail "no line like '$2' in $1:"$'\n'"$(cat results/t/.jobs/*/*.log)"
}
requests() {
  sdiag | awk '/^\tREQUEST_/ && match($0, /count:[0-9]+/) { n += substr($0, RSTART + 6, RLENGTH - 6) }
    END { print n }'
}

# Replaces train by a version that misbehaves for one seed.
instead_of_train() { # what it does
  rm bin/train
  # shellcheck disable=SC2016
  printf '#!/bin/bash\nif [[ $* == *seed1/piae-dt/* && ! -e well ]]; then\n%s\nfi\nexec %s/train "$@"\n' \
    "$1" "$programs" >bin/train
  chmod +x bin/train
}

# Counts the lives of a job.
lives() { grep -c '^job: life started' results/t/.jobs/*/"$1"; }
