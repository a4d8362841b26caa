#!/bin/bash
# C++ files must be formatted by clang-format.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

program=$(clang_tool format)
files_matching '\.(cpp|hpp)$' "$@" | { xargs --no-run-if-empty "$program" --dry-run 2>&1 || true; } |
  awk -F: '
    /code should be clang-formatted/ { if (!($1 in count)) { files[++n] = $1; line[$1] = $2 } ++count[$1] }
    END {
      for (i = 1; i <= n; ++i)
        printf "%s:%d: not as clang-format leaves it (the first place of %d); clang-format -i %s\n",
               files[i], line[files[i]], count[files[i]], files[i]
    }'
