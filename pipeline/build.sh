#!/bin/bash
# Configures and builds into build/, on as many cores as memory permits.
# usage: pipeline/build.sh ARCH LIBTORCH TARGET...      (LIBTORCH: on or off)
# TARGETs are `programs`, `demo` (the programs that `make demo` runs), `tests`, `slow_tests`, `storm_parts`, `benches`
# and `benches_of_scale`. Other parts are not configured, so their packages are not needed. Two targets stand alone in
# folders of their own: `storm_inputs`, in build/storm/, with sanitizers; `package`, in build/package/, which packs its
# build.
set -euo pipefail

arch=$1 libtorch=$2
shift 2
# The build uses all cores regardless of the calling make's -j, because nothing else runs meanwhile.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

folder=build options=()
case $* in
  package) folder=build/package ;;
  storm_inputs) folder=build/storm options=(-DPIAE_SANITIZE=ON) ;;
  # The demo does not need LibTorch, but keeps a build with LibTorch as it is.
  demo) ! grep -qis '^PIAE_LIBTORCH:BOOL=on$' build/CMakeCache.txt || libtorch=on ;;
esac
mkdir -p "$folder"
exec 9>build/.lock
flock 9 # two simultaneous makes, as on a cluster, build once

# Memory for compiling a file with LibTorch's headers, in kB.
per_job=1200000
cores=$(env -u OMP_NUM_THREADS nproc)
memory=$(awk '/^MemAvailable/ { print $2 }' /proc/meminfo)
jobs=$((memory / per_job < cores ? memory / per_job : cores))

on_if_requested() { # extended regular expression, target...
  printf '%s\n' "${@:2}" | grep -qxE "$1" && echo on || echo off
}
# Ninja builds a tenth faster than make. A folder configured with make keeps it.
[[ -f $folder/CMakeCache.txt ]] || options+=(-G Ninja)
cmake -S . -B "$folder" "${options[@]}" "-DPIAE_ARCH=$arch" "-DPIAE_LIBTORCH=$libtorch" \
  "-DPIAE_TESTS=$(on_if_requested '(slow_)?tests|storm_.*' "$@")" \
  "-DPIAE_BENCH=$(on_if_requested 'benches.*' "$@")" >"$folder/configure.log" 2>&1 || {
  cat "$folder/configure.log" >&2
  echo "build: cmake could not configure; see above (also in $folder/configure.log)" >&2
  exit 1
}
# Hide the lines that appear when there is nothing to build.
cmake --build "$folder" --parallel $((jobs > 0 ? jobs : 1)) --target "$@" |
  { grep --line-buffered -vE '^\[ *[0-9]+%\] Built target|^Consolidate compiler|^ninja: no work|Re-checking globbed' || true; }
