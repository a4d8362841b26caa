#!/bin/bash
# Checks that comments and pages follow docs/glossary.md and CONTRIBUTING.md, as far as patterns can: in the lines that
# a change adds, in all of the named files, or with LINT=all in all files.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

sources='(\.(cpp|hpp|sh|sbatch|awk|toml|md|mk)|CMakeLists\.txt|Makefile)$'
patterns=pipeline/lint/english.txt
before=$(commit_before_change)
if (($#)) || [[ ${LINT:-} == all || ! $before ]]; then
  files_matching "$sources" "$@" | { grep -vE '^results/' || true; } |
    xargs --no-run-if-empty awk -f pipeline/lint/english.awk "$patterns"
else
  mapfile -t files < <(files_to_check "$sources" | grep -vE '^results/')
  { git diff --unified=0 "$before" -- "${files[@]}" && git ls-files --others --exclude-standard -- "${files[@]}" |
    while read -r file; do git diff --unified=0 --no-index /dev/null "$file" || true; done; } |
    awk -f pipeline/lint/english.awk "$patterns" -
fi
