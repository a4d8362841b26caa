#pragma once

#include <cstdint>

#include "nets/rows.hpp"

namespace piae::nets {

/// A convolution with a stride along time, between a fine side and a coarse side that has one time
/// for every `stride` fine ones:
///
///   coarse[t][o] = sum over taps j and fine channels c of
///                  fine[stride t - padding + j][c] weight[o][c][j]
///
/// What the sum reads outside the fine side is zero. The kernel is two strides wide and half a
/// stride of zeros stands at either end, so that lengths divide exactly.
///
/// A transposed convolution is the same the other way round: its output is what a convolution gives
/// for the gradient by its input. Hence the functions below are all that either needs.
struct StridedConvolution {
  std::int64_t fine_channels;
  std::int64_t coarse_channels;  ///< a multiple of row_granule (base/vector.hpp)
  std::int64_t stride;           ///< fine times, even
  std::int64_t coarse_length;    ///< times

  [[nodiscard]] std::int64_t kernel() const { return 2 * stride; }
  [[nodiscard]] std::int64_t padding() const { return stride / 2; }
  [[nodiscard]] std::int64_t fine_length() const { return stride * coarse_length; }
};

// A row of a batch is a signal [time, channel]. Beyond both ends of a row on the fine side,
// padding() times must be there and be zero, and one time on the coarse side (padded_batch.hpp). So
// the numbers under the kernel lie in memory one after the other, those of neighbouring outputs
// overlap, and each function is a product of matrices for which nothing is copied. A weight is held
// as it is stored: row o has the numbers [fine channel, tap].

/// From fine to coarse.
template <class T>
void convolve(const StridedConvolution& shape, std::int64_t rows, Rows<const T> fine,
              Rows<const T> weight, Rows<T> coarse);

/// From coarse to fine. The times beyond both ends of the fine side are left zero.
template <class T>
void convolve_transposed(const StridedConvolution& shape, std::int64_t rows, Rows<const T> coarse,
                         Rows<const T> weight, Rows<T> fine);

/// The gradient by the weight, of one of the sides and the gradient by the other.
template <class T>
void weight_gradient(const StridedConvolution& shape, std::int64_t rows, Rows<const T> fine,
                     Rows<const T> coarse, Rows<T> gradient);

}  // namespace piae::nets
