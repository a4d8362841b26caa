# shellcheck shell=bash
# Sourced by the tests of the Makefile, pipeline/ and jobs/: each of their functions named test_* runs in a fresh copy
# of these, with stand-ins for the stage programs, without network or rights. Only the programs `plan` and `status` are
# real: PIAE_BIN names their folder, PIAE_STAND_IN the stand-in.

project=$(realpath "${BASH_SOURCE[0]%/*}/../..")
programs=$(realpath "${PIAE_BIN:-$project/build/bin}")
stand_in=${PIAE_STAND_IN:-$project/build/tests/stand_in}
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

# Returns the last commit, up to this one, of what decides stored results, in the project of the current folder.
decisive_commit() { # commit
  local decisive
  read -ra decisive < <(sed -n 's/^decisive=(\(.*\))$/\1/p' pipeline/reference_all.sh)
  git log -1 --abbrev=8 --format=%h "$1" -- "${decisive[@]}"
}

# Skips a test if a program is missing.
skip() {
  echo "$1" >"$skipped_because"
  exit 77
}

# figures need both (pipeline/figures/draw.sh)
skip_where_nothing_draws() {
  { command -v gnuplot && command -v qpdf; } >/dev/null || skip "gnuplot or qpdf is not installed"
}

# True once the stage of a step runs. The second line of the log, `step: started at TIME`, is older than that.
stage_has_started() { grep -qsE '^step: (started|waited .* s)$' "$1"; } # log

wait_for() { # file
  local tries=0
  until [[ -e $1 ]]; do
    sleep 0.05
    ((++tries < 600)) || fail "$1 did not come"
  done
}

# Makes programs that stand in for the stages (stand_in.cpp); only `plan` and `status` are real.
stand_ins() {
  mkdir fake
  local stage
  for stage in ingest simulate split train generate score diagnose tabulate sweep contrast identify readings transfer \
    trust classify verdicts; do
    ln -s "$stand_in" "fake/$stage"
  done
  ln -s "$programs/plan" "$programs/status" fake
  cat >fake/figures <<'STAGE'
#!/bin/bash
while (($#)); do
  case $1 in
    --run) run=$2 ;;
    --dataset) dataset=$2 ;;
  esac
  shift
done
mkdir -p "$run/$dataset/figures"
echo "figures: wrote the numbers of none"
STAGE
  printf '#!/bin/bash\necho "report: $*" >>reports\n' >fake/report
  chmod +x fake/figures fake/report
}

# Prints the command of the step with this log.
command_of() { head -n 1 "results/t/$1.log"; }

# Counts the stages that ran since the last call: "12 diagnose, 4 train".
ran_with_features() {
  [[ -e calls ]] || return 0
  awk '{ n[$1]++ } END { for (stage in n) print n[stage], stage }' calls | sort -k2 | paste -sd, | sed 's/,/, /g'
  rm calls
}
# The same without trainings that keep features.
ran() {
  [[ ! -e calls ]] || sed -i '/^features /d' calls
  ran_with_features
}

# Enters a folder with everything that a run needs, and with stand-ins.
enter() { # folder
  cp -r "$project"/{Makefile,jobs,pipeline} "$1"
  cd "$1" || exit
  mkdir results
  cp -r "$project/results/published" results
  stand_ins
}

# Runs all tests of the script, or only the named ones.
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
    # Google Test's format, so that count.awk finds the reason.
    echo "${0##*/}: Skipped"
    cat "$skipped_because"
    failures=77
  fi
  rm -f "$skipped_because"
  return $failures
}
