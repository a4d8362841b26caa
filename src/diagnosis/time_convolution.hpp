#pragma once

#include <cstdint>

namespace piae::diagnosis {

/// A convolution along time, computed as matrix products. A batch lies in memory as [time, window,
/// channel]. So one tap of the kernel multiplies a matrix of all windows at all times, and the
/// matrix of the next tap begins one time later; nothing is copied, padded or discarded.
///
/// The stride is 1. A convolution with stride s becomes one with stride 1 by treating s samples as
/// s channels of one time. A dense layer is a convolution as wide as its input is long.
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

/// Computes output [output_length, windows, outputs] from input [input_length, windows, inputs] and
/// weight [width, inputs, outputs].
template <class T>
void convolve(const TimeConvolution& shape, std::int64_t windows, const T* input, const T* weight,
              T* output);

/// Computes the gradient with respect to the weight, in the weight's shape, from the gradient with
/// respect to the output.
template <class T>
void weight_gradient(const TimeConvolution& shape, std::int64_t windows, const T* input,
                     const T* output_gradient, T* gradient);

/// Computes the gradient with respect to the input, in the input's shape, from the gradient with
/// respect to the output. `transposed` is scratch memory for shape.weights() numbers.
template <class T>
void input_gradient(const TimeConvolution& shape, std::int64_t windows, const T* weight,
                    const T* output_gradient, T* transposed, T* gradient);

}  // namespace piae::diagnosis
