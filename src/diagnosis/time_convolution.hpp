#pragma once

#include <cstdint>

namespace piae::diagnosis {

/// A convolution along time, computed as matrix products. A batch lies in memory as [time, window,
/// channel]. What one tap of the kernel multiplies is then a matrix of all windows at all times,
/// and that of the next tap begins one time further on, so nothing needs to be copied, padded or
/// thrown away.
///
/// The stride is 1. A convolution with stride s becomes one with stride 1 when s samples are read
/// as s channels of one time. A dense layer is a convolution that is as wide as its input is long.
struct TimeConvolution {
  std::int64_t inputs;        ///< channels, a multiple of row_granule
  std::int64_t outputs;       ///< channels, a multiple of row_granule
  std::int64_t width;         ///< taps
  std::int64_t padding;       ///< zeros before the first and after the last time
  std::int64_t input_length;  ///< times

  [[nodiscard]] std::int64_t output_length() const {
    return input_length + 2 * padding - width + 1;
  }
  [[nodiscard]] std::int64_t weights() const { return width * inputs * outputs; }
};

/// Output [output_length, windows, outputs] of input [input_length, windows, inputs] and weight
/// [width, inputs, outputs].
template <class T>
void convolve(const TimeConvolution& shape, std::int64_t windows, const T* input, const T* weight,
              T* output);

/// Computes the gradient by the weight, in the weight's shape, from that by the output.
template <class T>
void weight_gradient(const TimeConvolution& shape, std::int64_t windows, const T* input,
                     const T* output_gradient, T* gradient);

/// Computes the gradient by the input, in the input's shape, from that by the output. `transposed`
/// is scratch memory for shape.weights() numbers.
template <class T>
void input_gradient(const TimeConvolution& shape, std::int64_t windows, const T* weight,
                    const T* output_gradient, T* transposed, T* gradient);

}  // namespace piae::diagnosis
