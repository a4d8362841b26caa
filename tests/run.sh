#!/bin/bash
# Runs the tests that were built, and ends with the ten slowest, what was left out, and a line that counts.
# usage: DATA_DIR=... tests/run.sh quick|all      from the project's folder
# A quick test may take five minutes and a slow one 30; PIAE_TEST_PATIENCE=N multiplies both, for slow machines.
set -uo pipefail

case ${1:-} in
  quick) tiers=(quick) ;;
  all) tiers=(quick slow) ;;
  *)
    sed -n 's/^# usage: /usage: /p' "$0" >&2
    exit 2
    ;;
esac
patience=${PIAE_TEST_PATIENCE:-1}
[[ $patience =~ ^[1-9][0-9]*$ ]] || {
  echo "PIAE_TEST_PATIENCE: a whole number from 1, not '$patience'" >&2
  exit 2
}
declare -A seconds=([quick]=300 [slow]=1800)

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

# One job more than there are cores: the tests on a Slurm mostly wait.
jobs=$(($(env -u OMP_NUM_THREADS nproc) + 1))
rm -rf build/tests-of-rooms build/tests-*.xml
status=0 reports=()
for tier in "${tiers[@]}"; do
  reports+=("$PWD/build/tests-$tier.xml")
  options=()
  [[ $tier == quick ]] || options=(--fixture-exclude-setup tiny_chain) # the quick tests have made it
  ctest --test-dir build --parallel $jobs --label-regex "^$tier\$" --timeout $((seconds[$tier] * patience)) "${options[@]}" \
    --output-on-failure --no-tests=error --output-junit "${reports[-1]}" || status=1
done

shopt -s nullglob # a room whose program crashed has no report
awk -f tests/slowest.awk "${reports[@]}"
if [[ $1 == quick ]]; then
  echo "left out: the slow tests (LibTorch, whole grids, installing, Slurm, storms); \`make test-all\` runs them, too"
fi
awk -f tests/count.awk build/tests-of-rooms/*.xml "${reports[@]}" || status=1
exit $status
