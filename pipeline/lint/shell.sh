#!/bin/bash
# Scripts are clean by shellcheck, which says what would be right.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

command -v shellcheck >/dev/null || skip "as shellcheck is not installed"
# It exits with 1 where it has found something, and with more where it could not look.
files_matching '\.(sh|sbatch)$|^(\.ci/run|packaging/piae-dt)$' "$@" |
  { xargs --no-run-if-empty shellcheck --external-sources --format=gcc || (($? == 123)); } |
  sed -E 's/^([^:]+:[0-9]+):[0-9]+: [a-z]+: /\1: /'
