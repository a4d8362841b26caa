# shellcheck shell=bash
# What steps and benchmarks compute in; to be sourced. It is set and not inherited: what a login shell
# happens to have would change the bytes of artefacts. (CUDA_VISIBLE_DEVICES stays, which schedulers set.)
for variable in "${!OMP_@}" "${!GOMP_@}" "${!KMP_@}" "${!MKL_@}" "${!OPENBLAS_@}" "${!GOTO_@}" \
  "${!ATEN_@}" "${!TORCH_@}" "${!DNNL_@}" "${!ONEDNN_@}" "${!CUBLAS_@}" "${!NVIDIA_TF32@}"; do
  unset "$variable"
done
# Memory comes in huge pages and is kept for the next use: fresh pages are half of what reading
# costs, and networks that do not fit a page table's cache train slower.
tunables=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=1073741824
export GLIBC_TUNABLES=$tunables:glibc.malloc.trim_threshold=1073741824
export OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1
