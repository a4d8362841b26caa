#!/bin/bash
# Lines must not end with spaces, and only files of make may have tabs.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

sources='(\.(cpp|hpp|in|sh|sbatch|awk|toml|md|mk|cmake|cff)|CMakeLists\.txt|Makefile|^\.ci/run|^packaging/piae-dt)$'
tab=$'\t'
# shellcheck disable=SC2016
files_matching "$sources" "$@" | xargs --no-run-if-empty awk -v tab="$tab" '
  /[ \t\r]$/ { printf "%s:%d: ends with white space; remove it\n", FILENAME, FNR }
  FILENAME !~ /(\.mk|Makefile)$/ && index($0, tab) { printf "%s:%d: has a tab; use spaces\n", FILENAME, FNR }'
