#!/bin/bash
# Runs every test that was built, and ends with a line that counts them.
# usage: DATA_DIR=... tests/run.sh      from the project's folder
set -uo pipefail

# Tests on real recordings look for them here, and skip themselves when it is not set.
if [[ -d ${DATA_DIR:-} ]]; then
  DATA_DIR=$(realpath "$DATA_DIR")
  export DATA_DIR
else
  unset DATA_DIR
fi
# Tests call make and the stages as a user does, not as parts of the make that called.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

report=$PWD/build/tests.xml
rm -rf "$report" build/tests-of-rooms
# One more than there are cores: those on a Slurm wait most of the time.
ctest --test-dir build --parallel $(($(env -u OMP_NUM_THREADS nproc) + 1)) --output-on-failure \
  --no-tests=error --output-junit "$report"
status=$?

shopt -s nullglob # a room whose program crashed has no report
awk -f tests/count.awk build/tests-of-rooms/*.xml "$report" || status=1
exit $status
