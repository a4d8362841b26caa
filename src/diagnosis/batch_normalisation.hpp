#pragma once

#include <cstdint>

namespace piae::diagnosis {

/// Batch normalisation, max-pooling over time and ReLU in one, on batches [time, window, channel]
/// (time_convolution.hpp). Normalised values are not kept: they are one multiplication away.
struct PooledShape {
  std::int64_t length;    ///< times before pooling
  std::int64_t windows;   ///< in the batch
  std::int64_t channels;  ///< a multiple of row_granule
  std::int64_t pooling;   ///< times to one, 1 or 2; what is left over at the end is not used

  [[nodiscard]] std::int64_t pooled_length() const { return length / pooling; }
  [[nodiscard]] std::int64_t rows() const { return length * windows; }
};

/// Of each channel; all arrays are [channels].
template <class T>
struct Normalisation {
  const T* scale;
  const T* shift;
  T* running_mean;
  T* running_variance;
  // Found by use_batch_statistics() or use_running_statistics():
  T* mean;
  T* inverse_deviation;  ///< 1 / sqrt(variance + epsilon)
};

/// Mean and biased variance of the batch x; they enter the running ones (wdcnn_layers.hpp,
/// BatchNormalisation).
template <class T>
void use_batch_statistics(const PooledShape& shape, const T* x, const Normalisation<T>& n);

/// The running ones instead.
template <class T>
void use_running_statistics(std::int64_t channels, const Normalisation<T>& n);

/// y [pooled_length, windows, channels] = ReLU of the maximum of normalised x [length, windows,
/// channels]. NaN stays NaN.
template <class T>
void normalise_and_pool(const PooledShape& shape, const T* x, const Normalisation<T>& n, T* y);

/// From the gradient by y to those by x, scale and shift, after use_batch_statistics(). Of equal
/// values the first is the maximum.
template <class T>
void normalise_and_pool_gradient(const PooledShape& shape, const T* x, const Normalisation<T>& n,
                                 const T* y_gradient, T* x_gradient, T* scale_gradient,
                                 T* shift_gradient);

}  // namespace piae::diagnosis
