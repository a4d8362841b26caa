#include "diagnosis/batch_normalisation.hpp"

#include <cmath>

#include "base/vector.hpp"
#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

/// Returns the sum of f(row) over the rows [0, n). Four partial sums are more precise, and no
/// addition waits for the previous one.
template <class T, class Function>
Vector<T> sum_over(std::int64_t n, const Function& f) {
  Vector<T> sums[4] = {};
  std::int64_t row = 0;
  for (; row + 4 <= n; row += 4) {
    for (int part = 0; part < 4; ++part) sums[part] += f(row + part);
  }
  for (; row < n; ++row) sums[0] += f(row);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Normalisation of as many channels of a layer as a vector holds.
template <class T>
struct Channels {
  Channels(const Normalisation<T>& n, std::int64_t first)
      : mean(load(n.mean + first)),
        inverse_deviation(load(n.inverse_deviation + first)),
        factor(load(n.scale + first) * inverse_deviation),
        offset(load(n.shift + first) - mean * factor) {}

  [[nodiscard]] Vector<T> normalised(const Vector<T>& x) const { return x * factor + offset; }

  Vector<T> mean;
  Vector<T> inverse_deviation;
  Vector<T> factor;
  Vector<T> offset;
};

/// Calls f(from, to) for each row of y [pooled_length, windows, channels]. `to` is the row's start
/// in y; `from` is the start in x of the first row pooled into it. A second row, if any, lies one
/// time later.
template <class Function>
void for_each_pool(const PooledShape& shape, const Function& f) {
  const std::int64_t time = shape.windows * shape.channels;
  for (std::int64_t t = 0; t < shape.pooled_length(); ++t) {
    for (std::int64_t row = 0; row < time; row += shape.channels) {
      f(t * shape.pooling * time + row, t * time + row);
    }
  }
}

/// True if the first of two values is the maximum. NaN counts as the maximum, so that no NaN is
/// lost.
template <class T>
auto first_is_maximum(const Vector<T>& first, const Vector<T>& second) {
  return (first >= second) | (first != first);
}

/// The one or two values of x that were pooled into one value of y, and the gradients with respect
/// to their normalised values.
template <class T, int pooling>
struct PoolGradient {
  PoolGradient(const Channels<T>& channels, const T* x, std::int64_t time, const T* y_gradient) {
    value[0] = load(x);
    Vector<T> maximum = channels.normalised(value[0]);
    auto first_wins = maximum == maximum;
    if constexpr (pooling == 2) {
      value[1] = load(x + time);
      const Vector<T> second = channels.normalised(value[1]);
      first_wins = first_is_maximum<T>(maximum, second);
      maximum = first_wins ? maximum : second;
    }
    const Vector<T> none = {};
    const Vector<T> passed = maximum > none ? load(y_gradient) : none;
    gradient[0] = first_wins ? passed : none;
    if constexpr (pooling == 2) gradient[1] = first_wins ? none : passed;
  }

  Vector<T> value[pooling];
  Vector<T> gradient[pooling];
};

template <class T, int pooling>
void pool_forward(const PooledShape& shape, const T* x, const Normalisation<T>& n, T* y) {
  const std::int64_t time = shape.windows * shape.channels;
  for (std::int64_t c = 0; c < shape.channels; c += lanes<T>) {
    const Channels<T> channels(n, c);
    for_each_pool(shape, [&](std::int64_t from, std::int64_t to) {
      Vector<T> maximum = channels.normalised(load(x + from + c));
      if constexpr (pooling == 2) {
        const Vector<T> second = channels.normalised(load(x + from + time + c));
        maximum = first_is_maximum<T>(maximum, second) ? maximum : second;
      }
      const Vector<T> none = {};
      store(y + to + c, maximum < none ? none : maximum);
    });
  }
}

template <class T, int pooling>
void pool_backward(const PooledShape& shape, const T* x, const Normalisation<T>& n,
                   const T* y_gradient, T* x_gradient, T* scale_gradient, T* shift_gradient) {
  using Pool = PoolGradient<T, pooling>;
  const std::int64_t time = shape.windows * shape.channels;
  for (std::int64_t c = 0; c < shape.channels; c += lanes<T>) {
    const Channels<T> channels(n, c);
    Vector<T> sum = {};
    Vector<T> sum_of_products = {};  // gradient times (x less its mean)
    for_each_pool(shape, [&](std::int64_t from, std::int64_t to) {
      const Pool pool(channels, x + from + c, time, y_gradient + to + c);
      for (int i = 0; i < pooling; ++i) {
        sum += pool.gradient[i];
        sum_of_products += pool.gradient[i] * (pool.value[i] - channels.mean);
      }
    });
    sum_of_products *= channels.inverse_deviation;  // gradient times normalised x
    store(shift_gradient + c, sum);
    store(scale_gradient + c, sum_of_products);

    // x_gradient = factor (gradient - mean of gradients - normalised x * mean of products)
    const T share = T{1} / static_cast<T>(shape.rows());
    const Vector<T> slope = channels.factor * channels.inverse_deviation * sum_of_products * share;
    const Vector<T> constant = channels.factor * sum * share;
    for_each_pool(shape, [&](std::int64_t from, std::int64_t to) {
      const Pool pool(channels, x + from + c, time, y_gradient + to + c);
      for (int i = 0; i < pooling; ++i) {
        store(x_gradient + from + i * time + c, pool.gradient[i] * channels.factor - constant -
                                                    (pool.value[i] - channels.mean) * slope);
      }
    });
    for (std::int64_t left = shape.pooled_length() * pooling * time; left < shape.length * time;
         left += shape.channels) {
      store(x_gradient + left + c, -constant - (load(x + left + c) - channels.mean) * slope);
    }
  }
}

}  // namespace

template <class T>
void use_batch_statistics(const PooledShape& shape, const T* x, const Normalisation<T>& n) {
  const auto count = static_cast<T>(shape.rows());
  constexpr auto momentum = static_cast<T>(BatchNormalisation::momentum);
  for (std::int64_t c = 0; c < shape.channels; c += lanes<T>) {
    const auto value = [&](std::int64_t row) { return load(x + row * shape.channels + c); };
    const Vector<T> mean = sum_over<T>(shape.rows(), value) / count;
    const Vector<T> squares = sum_over<T>(shape.rows(), [&](std::int64_t row) {
      const Vector<T> deviation = value(row) - mean;
      return deviation * deviation;
    });
    store(n.mean + c, mean);
    for (std::int64_t i = 0; i < lanes<T>; ++i) {
      n.inverse_deviation[c + i] =
          1 / std::sqrt(squares[i] / count + static_cast<T>(BatchNormalisation::epsilon));
      T& running_mean = n.running_mean[c + i];
      T& running_variance = n.running_variance[c + i];
      running_mean += momentum * (mean[i] - running_mean);
      running_variance += momentum * (squares[i] / (count - 1) - running_variance);
    }
  }
}

template <class T>
void use_running_statistics(std::int64_t channels, const Normalisation<T>& n) {
  for (std::int64_t c = 0; c < channels; ++c) {
    n.mean[c] = n.running_mean[c];
    n.inverse_deviation[c] =
        1 / std::sqrt(n.running_variance[c] + static_cast<T>(BatchNormalisation::epsilon));
  }
}

template <class T>
void normalise_and_pool(const PooledShape& shape, const T* x, const Normalisation<T>& n, T* y) {
  const auto run = shape.pooling == 1 ? pool_forward<T, 1> : pool_forward<T, 2>;
  run(shape, x, n, y);
}

template <class T>
void normalise_and_pool_gradient(const PooledShape& shape, const T* x, const Normalisation<T>& n,
                                 const T* y_gradient, T* x_gradient, T* scale_gradient,
                                 T* shift_gradient) {
  const auto run = shape.pooling == 1 ? pool_backward<T, 1> : pool_backward<T, 2>;
  run(shape, x, n, y_gradient, x_gradient, scale_gradient, shift_gradient);
}

template void use_batch_statistics(const PooledShape&, const float*, const Normalisation<float>&);
template void use_batch_statistics(const PooledShape&, const double*, const Normalisation<double>&);
template void use_running_statistics(std::int64_t, const Normalisation<float>&);
template void use_running_statistics(std::int64_t, const Normalisation<double>&);
template void normalise_and_pool(const PooledShape&, const float*, const Normalisation<float>&,
                                 float*);
template void normalise_and_pool(const PooledShape&, const double*, const Normalisation<double>&,
                                 double*);
template void normalise_and_pool_gradient(const PooledShape&, const float*,
                                          const Normalisation<float>&, const float*, float*, float*,
                                          float*);
template void normalise_and_pool_gradient(const PooledShape&, const double*,
                                          const Normalisation<double>&, const double*, double*,
                                          double*, double*);

}  // namespace piae::diagnosis
