#pragma once

#include <cstdint>

namespace piae::diagnosis {

/// Convolutions along time as matrix products. A batch lies in memory as [time, window, channel]:
/// what a tap of the kernel multiplies is then a matrix of all windows at all times, the next tap's
/// begins one time further on, and nothing needs to be copied, padded or thrown away.
///
/// Stride is 1. A wider one becomes 1 when as many samples as it has are read as channels of one
/// time. A dense layer is a convolution as wide as its input is long.
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

/// Gradient by the weight, in its shape, from that by the output.
template <class T>
void weight_gradient(const TimeConvolution& shape, std::int64_t windows, const T* input,
                     const T* output_gradient, T* gradient);

/// Gradient by the input, in its shape, from that by the output. `transposed` is scratch for
/// shape.weights() numbers.
template <class T>
void input_gradient(const TimeConvolution& shape, std::int64_t windows, const T* weight,
                    const T* output_gradient, T* transposed, T* gradient);

}  // namespace piae::diagnosis
