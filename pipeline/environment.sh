# shellcheck shell=bash
# What steps and benchmarks compute in; to be sourced. What is set already stays.
#
# Memory comes in huge pages and is kept for the next use: fresh pages are half of what reading
# costs, and networks that do not fit a page table's cache train slower.
tunables=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=1073741824
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-$tunables:glibc.malloc.trim_threshold=1073741824}
export OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1}
