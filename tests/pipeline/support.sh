# shellcheck shell=bash
# Sourced by the tests of the Makefile, pipeline/ and jobs/: each of their functions named test_*
# runs in a fresh copy of those, with stand-ins for the stage programs, without network or rights. The
# program `settings`, which make asks what there is, is the real one: PIAE_BIN names its folder.

project=$(realpath "${BASH_SOURCE[0]%/*}/../..")
programs=$(realpath "${PIAE_BIN:-$project/build/bin}")
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES OMP_NUM_THREADS OPENBLAS_NUM_THREADS DATA_DIR

fail() {
  local i=1
  until [[ ${FUNCNAME[i]} == test_* ]]; do ((++i)); done
  echo "  line ${BASH_LINENO[i - 1]}: $1" >&2
  exit 1
}

expect_equal() { [[ $1 == "$2" ]] || fail "expected:"$'\n'"$2"$'\n'"  and got:"$'\n'"$1"; }
expect_line() { grep -qE -- "$2" <<<"$1" || fail "no line like '$2' in:"$'\n'"$1"; }
expect_no_line() { ! grep -qE -- "$2" <<<"$1" || fail "a line like '$2' in:"$'\n'"$1"; }
expect_exit() { # code, command...
  local code=0
  "${@:2}" >/dev/null 2>&1 || code=$?
  ((code == $1)) || fail "expected exit code $1, got $code from: ${*:2}"
}

# For a test that lacks a program that others have.
skip() {
  echo "$1" >"$skipped_because"
  exit 77
}

# Figures are drawn by both (pipeline/figures/draw.sh).
skip_where_nothing_draws() {
  { command -v gnuplot && command -v qpdf; } >/dev/null || skip "gnuplot or qpdf is not installed"
}

wait_for() { # file
  local tries=0
  until [[ -e $1 ]]; do
    sleep 0.05
    ((++tries < 600)) || fail "$1 did not come"
  done
}

# What a stage does to the files: copies of its options into its outputs, and a line in `calls`.
stand_ins() {
  mkdir fake
  cat >fake/stage <<'STAGE'
#!/bin/bash
stage=${0##*/} options="$*" outputs=()
tables=(accuracy.csv gains.csv quality.csv comparisons.csv ranks.csv decisions.csv confidence.csv recommendation.csv tables.md tables.tex summary.txt)
[[ $stage != sweep ]] || tables=(sweep.csv sweep.md)
if [[ $stage == sweep && $options == *" --method "* ]]; then
  method=${options#* --method }
  tables=("${tables[@]/#sweep/sweep@${method%% *}}")
fi
[[ $stage != readings ]] || tables=(readings.csv readings.md)
[[ $stage != trust ]] || tables=(trust.csv trust.md)
[[ $stage != identify ]] || tables=(identifiability.csv scatter.csv identifiability.md)
while (($#)); do
  case $1 in
    --output | --keep-classifier) outputs+=("$2") ;;
    --output-dir) outputs+=("$2"/{A,B,C,D}.h5) ;;
    --run) run=$2 ;;
    --dataset) outputs+=("${tables[@]/#/$run/$2/}") ;;
    --group) outputs+=("$run/transfer@$2".{csv,md} "$run/transfer-comparisons@$2.csv") ;;
  esac
  shift
done
cell=${outputs[0]#results/*/}
if [[ -e broken && $(<broken) == "$stage $cell" ]]; then
  echo "$stage: the reason" >&2
  exit 65
fi
called=$stage
[[ $options != *--keep-features* ]] || called=features
[[ $options != *--keep-classifier* ]] || called=keep
echo "$called ${cell%/*}" >>calls
for output in "${outputs[@]}"; do echo "$stage $options" >"$output"; done
echo "$stage: 1 thing done"
STAGE
  chmod +x fake/stage
  local stage
  for stage in ingest simulate split train generate score diagnose tabulate sweep contrast identify readings transfer \
    trust; do
    ln -s stage "fake/$stage"
  done
  ln -s "$programs/settings" fake/settings
  cat >fake/figures <<'STAGE'
#!/bin/bash
mkdir -p "$2/$4/figures" # --run FOLDER --dataset NAME
echo "figures: wrote the numbers of none"
STAGE
  printf '#!/bin/bash\necho "report: $*" >>reports\n' >fake/report
  chmod +x fake/figures fake/report
}

# The stages that ran since the last call, counted: "12 diagnose, 4 train".
ran_with_features() {
  [[ -e calls ]] || return 0
  awk '{ n[$1]++ } END { for (stage in n) print n[stage], stage }' calls | sort -k2 | paste -sd, | sed 's/,/, /g'
  rm calls
}
# The same without the trainings whose features are kept.
ran() {
  [[ ! -e calls ]] || sed -i '/^features /d' calls
  ran_with_features
}

# Goes into a folder with all that a run needs, and with stand-ins.
enter() { # folder
  cp -r "$project"/{Makefile,jobs,pipeline} "$1"
  cd "$1" || exit
  mkdir results
  cp -r "$project/results/published" results
  stand_ins
}

# All tests of the script, or only those named.
run_tests() { # names
  local test tests=("$@") failures=0 code began skipped_because
  skipped_because=$(mktemp)
  (($#)) || mapfile -t tests < <(declare -F | awk '$3 ~ /^test_/ { print $3 }')
  for test in "${tests[@]}"; do
    local folder
    began=$SECONDS
    folder=$(mktemp -d)
    ( # not in the condition itself, where bash would let `set -e` pass
      set -e
      enter "$folder"
      "$test"
    )
    code=$?
    case $code in
      0) echo "passed: $test ($((SECONDS - began)) s)" ;;
      77) echo "skipped: $test" ;;
      *)
        echo "FAILED: $test" >&2
        failures=$((failures + 1))
        ;;
    esac
    rm -rf "$folder"
  done
  if ((failures == 0)) && [[ -s $skipped_because ]]; then
    # As Google Test says it, so that count.awk finds the reason.
    echo "${0##*/}: Skipped"
    cat "$skipped_because"
    failures=77
  fi
  rm -f "$skipped_because"
  return $failures
}
