#!/bin/bash
# A helper in the anonymous namespace of a file must have a name that is unique among the functions of its room. The
# compiler joins the files of a room: a helper of the same name would be an overload and could be called by mistake.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

files_matching '^src/.*\.(cpp|hpp)$' | xargs --no-run-if-empty awk -f pipeline/lint/names.awk
