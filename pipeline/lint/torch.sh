#!/bin/bash
# Only the room of LibTorch, its tests and the benchmarks may include LibTorch's headers.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/common.sh"

files_matching '\.(cpp|hpp|in)$' "$@" | { grep -vE '^(src/libtorch|tests/slow/libtorch|tests/bench)/' || true; } |
  xargs --no-run-if-empty awk '
    /^[ \t]*#[ \t]*include[ \t]*[<"](torch|ATen|c10|caffe2|libtorch)[\/.]/ {
      printf "%s:%d: includes LibTorch outside src/libtorch; ", FILENAME, FNR
      print "move it there and declare in src/seam/libtorch.hpp what others may call"
    }'
