#pragma once

#include <cstdint>

namespace piae::diagnosis {

// Batch normalisation, max-pooling over time and ReLU in one pass, on batches [time, window,
// channel] (time_convolution.hpp). Normalised values are not stored, because recomputing one takes
// only a multiplication and an addition.

/// Shape of the data to be normalised and pooled.
struct PooledShape {
  std::int64_t length;    ///< times before pooling
  std::int64_t windows;   ///< in a batch
  std::int64_t channels;  ///< a multiple of row_granule
  std::int64_t pooling;   ///< 1 or 2 times that become one; a last odd time is ignored

  [[nodiscard]] std::int64_t pooled_length() const { return length / pooling; }
  [[nodiscard]] std::int64_t rows() const { return length * windows; }
};

/// Parameters and statistics of batch normalisation; every array is [channels].
template <class T>
struct Normalisation {
  const T* scale;
  const T* shift;
  T* running_mean;
  T* running_variance;
  // Statistics in use, set by use_batch_statistics() or use_running_statistics():
  T* mean;
  T* inverse_deviation;  ///< 1 / sqrt(variance + epsilon)
};

/// Uses the mean and biased variance of the batch x [length, windows, channels], and updates the
/// running statistics (BatchNormalisation in wdcnn_layers.hpp).
template <class T>
void use_batch_statistics(const PooledShape& shape, const T* x, const Normalisation<T>& n);

/// Uses the running statistics instead.
template <class T>
void use_running_statistics(std::int64_t channels, const Normalisation<T>& n);

/// Normalises x [length, windows, channels], takes the maximum over each `pooling` times, then
/// ReLU, into y [pooled_length, windows, channels]. NaN stays NaN.
template <class T>
void normalise_and_pool(const PooledShape& shape, const T* x, const Normalisation<T>& n, T* y);

/// Computes the gradients with respect to x, scale and shift from the gradient with respect to y,
/// after use_batch_statistics(). If two values are equal, the first counts as the maximum.
template <class T>
void normalise_and_pool_gradient(const PooledShape& shape, const T* x, const Normalisation<T>& n,
                                 const T* y_gradient, T* x_gradient, T* scale_gradient,
                                 T* shift_gradient);

}  // namespace piae::diagnosis
