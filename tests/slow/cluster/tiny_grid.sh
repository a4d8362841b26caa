# shellcheck shell=bash
# shellcheck disable=SC2154 # the two that come before it set what it reads
# The tiny grid of tests/reference with the real programs, for tests on Slurm; to be sourced after slurm.sh and
# tests/pipeline/support.sh. Its training takes some seconds, so that it can be stopped.

# Makes every step a job of its own.
# shellcheck disable=SC2034
one_job_a_step="srun --quiet --nodes=1 --ntasks=1 --cpus-per-task=1 --mem=500"
model=results/tiny/tiny/seed0/piae-dt/model.h5
training=${model%/*}/train.log

lay_out_grid() {
  rm -rf pipeline/datasets results
  mkdir -p pipeline/datasets results
  cp "$project/tests/reference/tiny.toml" pipeline/datasets
  cp "$project/tests/reference/protocol.toml" pipeline
  sed -i 's/^epochs = 20/epochs = 5000/' pipeline/protocol.toml
  cp -r "$project/results/published" results
}

# An array of words, so that `"${tiny[@]}" ... &` is make itself.
tiny=(make --silent "BIN=$programs" RUN=tiny DATASETS=tiny "METHODS=none smote piae-dt" "RATIOS=100to1 10to1"
  "SEEDS=0 1")
tiny() { "${tiny[@]}" "$@"; }

# Makes the same with `make -j2`, once for all tests of a script; call it before run_tests.
make_alone() {
  alone=$slurm_folder/alone
  mkdir "$alone"
  (
    cp -r "$project"/{Makefile,pipeline,jobs} "$alone"
    cd "$alone" || exit
    lay_out_grid
    tiny -j2 tables >messages 2>&1 || {
      cat messages >&2
      exit 1
    }
  )
}

# Ignores logs, which record times, and the journal, which records inodes. Finished steps do not leave checkpoints or
# partial files.
expect_same_as_alone() {
  diff -r --exclude='*.log' --exclude=.journal results/tiny "$alone/results/tiny" >difference ||
    fail "other bytes than those of make -j2: $(<difference)"
}

# Makes everything except one model and what depends on it.
nearly_done() {
  lay_out_grid
  cp -r --preserve=timestamps "$alone/results/tiny" results
  rm -r results/tiny/tiny/seed0/piae-dt
}

wait_until_it_trains() {
  until_true "piae-dt is trained" stage_has_started "$training"
  sleep 1
}
