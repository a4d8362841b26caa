#!/bin/bash
# Configures and builds into build/, on as many cores as there is memory for.
# usage: pipeline/build.sh ARCH LIBTORCH TARGET...      (LIBTORCH: on or off)
# TARGETs are `programs`, `demo` (the programs that `make demo` runs), `tests`, `slow_tests`, `storm_parts`, `benches` and
# `benches_of_scale`. What is not requested is not configured, so that it needs no packages. Two stand alone and have
# folders of their own: `storm_inputs`, in build/storm/, is built with sanitizers; `package`, in build/package/, packs
# what it has built.
set -euo pipefail

arch=$1 libtorch=$2
shift 2
# The build uses all cores, whatever -j the calling make has: nothing else runs until it is done.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

folder=build options=()
case $* in
  package) folder=build/package ;;
  storm_inputs) folder=build/storm options=(-DPIAE_SANITIZE=ON) ;;
  # The demo needs no LibTorch, but leaves a build that has it as it is.
  demo) ! grep -qis '^PIAE_LIBTORCH:BOOL=on$' build/CMakeCache.txt || libtorch=on ;;
esac
mkdir -p "$folder"
exec 9>build/.lock
flock 9 # two makes at once, as on a cluster, build once

# What a file with LibTorch's headers takes to compile, in kB.
per_job=1200000
cores=$(env -u OMP_NUM_THREADS nproc)
memory=$(awk '/^MemAvailable/ { print $2 }' /proc/meminfo)
jobs=$((memory / per_job < cores ? memory / per_job : cores))

on_if_requested() { # extended regular expression, target...
  printf '%s\n' "${@:2}" | grep -qxE "$1" && echo on || echo off
}
# Ninja builds a tenth faster than make does. A folder that make has configured stays with it.
[[ -f $folder/CMakeCache.txt ]] || options+=(-G Ninja)
cmake -S . -B "$folder" "${options[@]}" "-DPIAE_ARCH=$arch" "-DPIAE_LIBTORCH=$libtorch" \
  "-DPIAE_TESTS=$(on_if_requested '(slow_)?tests|storm_.*' "$@")" \
  "-DPIAE_BENCH=$(on_if_requested 'benches.*' "$@")" >"$folder/configure.log" 2>&1 || {
  cat "$folder/configure.log" >&2
  echo "build: cmake could not configure; above is why (also in $folder/configure.log)" >&2
  exit 1
}
# What is left when there is nothing to build says nothing.
cmake --build "$folder" --parallel $((jobs > 0 ? jobs : 1)) --target "$@" |
  { grep --line-buffered -vE '^\[ *[0-9]+%\] Built target|^Consolidate compiler|^ninja: no work|Re-checking globbed' || true; }
