#!/bin/bash
# Writes results/reference/SHA256SUMS, which names every stored file.
# usage: pipeline/sums.sh      from the project's folder
set -euo pipefail

cd results/reference
sums=$(find . -type f ! -name SHA256SUMS -printf '%P\0' | LC_ALL=C sort --zero-terminated | xargs --null --no-run-if-empty sha256sum)
printf '%s\n' "$sums" >SHA256SUMS
