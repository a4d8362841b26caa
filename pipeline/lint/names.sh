#!/bin/bash
# A helper, in the anonymous namespace of a file, has a name that no other file of its room gives a function. The compiler
# takes the files of a room together: a helper of the same name would be an overload, and could be called in place of the
# function that is meant.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

files_matching '^src/.*\.(cpp|hpp)$' | xargs --no-run-if-empty awk -f pipeline/lint/names.awk
