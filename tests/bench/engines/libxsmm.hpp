#pragma once

#include <cstdint>

#include "diagnosis/time_convolution.hpp"

// The three products of a convolution along time (diagnosis/time_convolution.hpp) by libxsmm's
// kernels, which it makes at run time for each shape: sums of products over the taps, or over parts
// of the depth.
namespace piae::bench::libxsmm {

void convolve(const diagnosis::TimeConvolution& shape, std::int64_t windows, const float* input,
              const float* weight, float* output);

void weight_gradient(const diagnosis::TimeConvolution& shape, std::int64_t windows,
                     const float* input, const float* output_gradient, float* gradient);

/// `transposed` is scratch memory for shape.weights() numbers.
void input_gradient(const diagnosis::TimeConvolution& shape, std::int64_t windows,
                    const float* weight, const float* output_gradient, float* transposed,
                    float* gradient);

}  // namespace piae::bench::libxsmm
