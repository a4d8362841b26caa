#!/bin/bash
# Scripts must be clean by shellcheck, which also suggests what would be right.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

command -v shellcheck >/dev/null || skip "because shellcheck is not installed"
# It exits with 1 after findings, and with higher codes if it could not check.
files_matching '\.(sh|sbatch)$|^(\.ci/run|packaging/piae-dt)$' "$@" |
  { xargs --no-run-if-empty shellcheck --external-sources --format=gcc || (($? == 123)); } |
  sed -E 's/^([^:]+:[0-9]+):[0-9]+: [a-z]+: /\1: /'
