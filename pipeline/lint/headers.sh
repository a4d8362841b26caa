#!/bin/bash
# Every header of the library must compile alone, so that files can include it without knowing its needs. Headers that
# have compiled and not changed since are skipped. A header with LibTorch takes as long as ten others, so only changed
# ones are compiled, unless LINT=all.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

flags_of() { compile_commands | awk -F'\t' -v file="$1" '$1 == file { print $2 }' | sed 's/ -o .*//'; }

configure
mapfile -t headers < <(files_matching '^src/.*\.hpp$' "$@" | { grep -v '^src/libtorch/' || true; })
[[ -z $has_libtorch ]] || mapfile -t -O ${#headers[@]} headers < <(files_to_check '^src/libtorch/.*\.hpp$' "$@")

stamps=$configured/headers
mkdir -p $stamps
flags=("$(flags_of src/base/random.cpp)" "$(flags_of src/libtorch/back_ends.cpp)")
[[ -e $stamps/flags && $(<$stamps/flags) == "${flags[*]}" ]] || echo "${flags[*]}" >$stamps/flags

unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
make --file=pipeline/lint/headers.mk --jobs="$cores" --silent STAMPS=$stamps HEADERS="${headers[*]}" \
  FLAGS="${flags[0]}" LIBTORCH_FLAGS="${flags[1]}"

for header in "${headers[@]}"; do
  [[ ! -e $stamps/$header.ok ]] || continue
  # Report the first error, which may be in a header that this one includes.
  error=$(grep -m1 -E 'error:' "$stamps/$header.log" | sed 's,^\./,,')
  [[ $error == "$header":* ]] || error="$header:1:1: error: $error"
  sed -E 's/^([^:]+:[0-9]+):[0-9]+: (fatal )?error: (.*)/\1: does not compile alone: \3; include what it uses/' <<<"$error"
done
