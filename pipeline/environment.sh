# shellcheck shell=bash
# Environment of steps and benchmarks; to be sourced. It is set and not inherited: a login shell's variables would
# change the bytes of artefacts. (CUDA_VISIBLE_DEVICES stays, since schedulers set it.)
for variable in "${!OMP_@}" "${!GOMP_@}" "${!KMP_@}" "${!MKL_@}" "${!OPENBLAS_@}" "${!GOTO_@}" \
  "${!ATEN_@}" "${!TORCH_@}" "${!DNNL_@}" "${!ONEDNN_@}" "${!CUBLAS_@}" "${!NVIDIA_TF32@}"; do
  unset "$variable"
done
# Use huge pages and keep freed memory: fresh pages are half of the cost of reading, and networks that exceed the page
# table's cache train more slowly.
tunables=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=1073741824
export GLIBC_TUNABLES=$tunables:glibc.malloc.trim_threshold=1073741824
export OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1
