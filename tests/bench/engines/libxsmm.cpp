#include "bench/engines/libxsmm.hpp"

#include <libxsmm.h>

#include <algorithm>
#include <stdexcept>

namespace piae::bench::libxsmm {

namespace {

using diagnosis::TimeConvolution;
using Kernel = libxsmm_smmfunction_reducebatch_strd;
using Size = libxsmm_blasint;

/// Returns the kernel of C = sum over blocks of A_b B_b for rows [rows, depth] of A and [depth,
/// columns] of B. libxsmm counts by columns, so A and B change places. It keeps its kernels, and
/// finds them again by their shape.
Kernel kernel_of(std::int64_t rows, std::int64_t columns, std::int64_t depth, std::int64_t a_block,
                 std::int64_t b_block, bool a_transposed) {
  const auto m = static_cast<Size>(columns);
  const auto n = static_cast<Size>(rows);
  const auto k = static_cast<Size>(depth);
  const Size ldb = a_transposed ? n : k;
  const float alpha = 1;
  const float beta = 0;
  const int flags = a_transposed ? LIBXSMM_GEMM_FLAG_TRANS_B : LIBXSMM_GEMM_FLAG_NONE;
  constexpr auto bytes = static_cast<std::int64_t>(sizeof(float));
  const Kernel kernel = libxsmm_smmdispatch_reducebatch_strd(
      m, n, k, static_cast<Size>(b_block * bytes), static_cast<Size>(a_block * bytes), &m, &ldb, &m,
      &alpha, &beta, &flags, nullptr);
  if (kernel == nullptr) throw std::runtime_error("libxsmm does not make this kernel");
  return kernel;
}

/// Sums the times of `from`, tap by tap, into those of `to`: as in diagnosis/time_convolution.cpp,
/// one product for each time, since libxsmm is made for products of a few dozen rows.
void apply(std::int64_t width, std::int64_t padding, std::int64_t windows, std::int64_t from_length,
           std::int64_t from_channels, std::int64_t to_length, std::int64_t to_channels,
           const float* from, const float* weight, float* to) {
  const std::int64_t from_time = windows * from_channels;
  const std::int64_t tap_weights = from_channels * to_channels;
  const Kernel kernel =
      kernel_of(windows, to_channels, from_channels, from_time, tap_weights, false);
  for (std::int64_t t = 0; t < to_length; ++t) {
    const std::int64_t first = t - padding;
    const std::int64_t begin = std::max<std::int64_t>(0, -first);
    const std::int64_t end = std::min(width, from_length - first);
    const auto taps = static_cast<unsigned long long>(end - begin);
    kernel(weight + begin * tap_weights, from + (first + begin) * from_time,
           to + t * windows * to_channels, &taps);
  }
}

}  // namespace

void convolve(const TimeConvolution& shape, std::int64_t windows, const float* input,
              const float* weight, float* output) {
  apply(shape.width, shape.padding, windows, shape.input_length, shape.inputs,
        shape.output_length(), shape.outputs, input, weight, output);
}

void weight_gradient(const TimeConvolution& shape, std::int64_t windows, const float* input,
                     const float* output_gradient, float* gradient) {
  // A block is one time.
  const std::int64_t input_time = windows * shape.inputs;
  const std::int64_t output_time = windows * shape.outputs;
  const Kernel kernel =
      kernel_of(shape.inputs, shape.outputs, windows, input_time, output_time, true);
  for (std::int64_t tap = 0; tap < shape.width; ++tap) {
    const std::int64_t shift = tap - shape.padding;
    const std::int64_t begin = std::max<std::int64_t>(0, -shift);
    const std::int64_t end = std::min(shape.output_length(), shape.input_length - shift);
    const auto times = static_cast<unsigned long long>(end - begin);
    kernel(output_gradient + begin * output_time, input + (begin + shift) * input_time,
           gradient + tap * shape.inputs * shape.outputs, &times);
  }
}

void input_gradient(const TimeConvolution& shape, std::int64_t windows, const float* weight,
                    const float* output_gradient, float* transposed, float* gradient) {
  for (std::int64_t tap = 0; tap < shape.width; ++tap) {
    libxsmm_otrans(transposed + (shape.width - 1 - tap) * shape.inputs * shape.outputs,
                   weight + tap * shape.inputs * shape.outputs, sizeof(float),
                   static_cast<Size>(shape.outputs), static_cast<Size>(shape.inputs),
                   static_cast<Size>(shape.outputs), static_cast<Size>(shape.inputs));
  }
  apply(shape.width, shape.width - 1 - shape.padding, windows, shape.output_length(), shape.outputs,
        shape.input_length, shape.inputs, output_gradient, transposed, gradient);
}

}  // namespace piae::bench::libxsmm
