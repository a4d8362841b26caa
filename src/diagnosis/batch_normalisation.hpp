#pragma once

#include <cstdint>

namespace piae::diagnosis {

// Batch normalisation, max-pooling over time and ReLU in one go, on batches [time, window, channel]
// (time_convolution.hpp). Normalised values are not stored, because it takes no more than a
// multiplication and an addition to compute them again.

/// The shape of what is normalised and pooled.
struct PooledShape {
  std::int64_t length;    ///< times before pooling
  std::int64_t windows;   ///< in the batch
  std::int64_t channels;  ///< a multiple of row_granule
  std::int64_t pooling;   ///< 1 or 2: how many times become one; one left over is not used

  [[nodiscard]] std::int64_t pooled_length() const { return length / pooling; }
  [[nodiscard]] std::int64_t rows() const { return length * windows; }
};

/// The parameters and statistics of batch normalisation; every array is [channels].
template <class T>
struct Normalisation {
  const T* scale;
  const T* shift;
  T* running_mean;
  T* running_variance;
  // The statistics in use, set by use_batch_statistics() or use_running_statistics():
  T* mean;
  T* inverse_deviation;  ///< 1 / sqrt(variance + epsilon)
};

/// Uses mean and biased variance of the batch x [length, windows, channels], and moves the running
/// statistics towards them (BatchNormalisation in wdcnn_layers.hpp).
template <class T>
void use_batch_statistics(const PooledShape& shape, const T* x, const Normalisation<T>& n);

/// Uses the running statistics instead.
template <class T>
void use_running_statistics(std::int64_t channels, const Normalisation<T>& n);

/// Normalises x [length, windows, channels], takes the maximum over each `pooling` times and then
/// ReLU: y [pooled_length, windows, channels]. NaN stays NaN.
template <class T>
void normalise_and_pool(const PooledShape& shape, const T* x, const Normalisation<T>& n, T* y);

/// Computes the gradients by x, scale and shift from that by y, after use_batch_statistics(). Of
/// two equal values, the first counts as the maximum.
template <class T>
void normalise_and_pool_gradient(const PooledShape& shape, const T* x, const Normalisation<T>& n,
                                 const T* y_gradient, T* x_gradient, T* scale_gradient,
                                 T* shift_gradient);

}  // namespace piae::diagnosis
