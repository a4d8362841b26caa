#include "diagnosis/time_convolution.hpp"

#include <algorithm>

#include "base/transpose.hpp"
#include "nets/matrix_product.hpp"

namespace piae::diagnosis {

namespace {

struct TimeRange {
  std::int64_t begin;
  std::int64_t end;

  bool operator==(const TimeRange&) const = default;
  [[nodiscard]] std::int64_t size() const { return end - begin; }
};

/// Returns the indices i in [0, n) for which first + i is in [0, length).
TimeRange inside(std::int64_t first, std::int64_t n, std::int64_t length) {
  return {std::max(std::int64_t{0}, -first), std::min(n, length - first)};
}

/// Shapes for summing the times of one batch, tap by tap, into those of another.
struct Taps {
  std::int64_t width;
  std::int64_t padding;
  std::int64_t from_length;
  std::int64_t from_channels;
  std::int64_t to_length;
  std::int64_t to_channels;
};

/// Computes to[t] = sum over taps k of from[t - padding + k] weight[k], for the taps at which
/// `from` has a time. Neighbouring times with the same taps are computed as one matrix product;
/// these are all times but the first and last few.
template <class T>
void apply(const Taps& taps, std::int64_t windows, const T* from, const T* weight, T* to) {
  for (std::int64_t begin = 0; begin < taps.to_length;) {
    const TimeRange reach = inside(begin - taps.padding, taps.width, taps.from_length);
    std::int64_t end = begin + 1;
    while (end < taps.to_length &&
           inside(end - taps.padding, taps.width, taps.from_length) == reach) {
      ++end;
    }
    const std::int64_t from_time = windows * taps.from_channels;
    const std::int64_t tap_weights = taps.from_channels * taps.to_channels;
    nets::multiply<T>({.a = from + (begin - taps.padding + reach.begin) * from_time,
                       .a_row = taps.from_channels,
                       .a_column = 1,
                       .b = weight + reach.begin * tap_weights,
                       .b_row = taps.to_channels,
                       .c = to + begin * windows * taps.to_channels,
                       .c_row = taps.to_channels,
                       .rows = (end - begin) * windows,
                       .columns = taps.to_channels,
                       .depth = taps.from_channels,
                       .blocks = reach.size(),
                       .a_block = from_time,
                       .b_block = tap_weights});
    begin = end;
  }
}

}  // namespace

template <class T>
void convolve(const TimeConvolution& shape, std::int64_t windows, const T* input, const T* weight,
              T* output) {
  apply({shape.width, shape.padding, shape.input_length, shape.inputs, shape.output_length(),
         shape.outputs},
        windows, input, weight, output);
}

template <class T>
void weight_gradient(const TimeConvolution& shape, std::int64_t windows, const T* input,
                     const T* output_gradient, T* gradient) {
  for (std::int64_t tap = 0; tap < shape.width; ++tap) {
    const std::int64_t shift = tap - shape.padding;
    const TimeRange times = inside(shift, shape.output_length(), shape.input_length);
    nets::multiply<T>({.a = input + (times.begin + shift) * windows * shape.inputs,
                       .a_row = 1,
                       .a_column = shape.inputs,
                       .b = output_gradient + times.begin * windows * shape.outputs,
                       .b_row = shape.outputs,
                       .c = gradient + tap * shape.inputs * shape.outputs,
                       .c_row = shape.outputs,
                       .rows = shape.inputs,
                       .columns = shape.outputs,
                       .depth = times.size() * windows});
  }
}

template <class T>
void input_gradient(const TimeConvolution& shape, std::int64_t windows, const T* weight,
                    const T* output_gradient, T* transposed, T* gradient) {
  // The gradient is a convolution from output to input, with the taps in reverse order.
  for (std::int64_t tap = 0; tap < shape.width; ++tap) {
    transpose(shape.inputs, shape.outputs, weight + tap * shape.inputs * shape.outputs,
              transposed + (shape.width - 1 - tap) * shape.inputs * shape.outputs);
  }
  apply({shape.width, shape.width - 1 - shape.padding, shape.output_length(), shape.outputs,
         shape.input_length, shape.inputs},
        windows, output_gradient, static_cast<const T*>(transposed), gradient);
}

template void convolve(const TimeConvolution&, std::int64_t, const float*, const float*, float*);
template void convolve(const TimeConvolution&, std::int64_t, const double*, const double*, double*);
template void weight_gradient(const TimeConvolution&, std::int64_t, const float*, const float*,
                              float*);
template void weight_gradient(const TimeConvolution&, std::int64_t, const double*, const double*,
                              double*);
template void input_gradient(const TimeConvolution&, std::int64_t, const float*, const float*,
                             float*, float*);
template void input_gradient(const TimeConvolution&, std::int64_t, const double*, const double*,
                             double*, double*);

}  // namespace piae::diagnosis
