#include "nets/dense_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/denormals.hpp"
#include "base/vector.hpp"

namespace piae::nets {

namespace {

/// Number of batch rows per pass over a weight, and number of weight rows that are read at the same
/// time. Both are as large as the number of vector registers allows.
constexpr int most_rows = 6;
constexpr int side_by_side = vector_registers >= 32 ? 4 : 2;
/// Number of vectors of a weight that take a step of Adam at the same time.
constexpr int adam_vectors = 4;

/// Returns the sum of the numbers in a vector: adds halves until one number is left.
template <class T>
T sum_of(Vector<T> vector) {
  T numbers[lanes<T>];
  store<T>(numbers, vector);
#pragma GCC unroll 8
  for (std::int64_t width = lanes<T> / 2; width > 0; width /= 2) {
#pragma GCC unroll 16
    for (std::int64_t i = 0; i < width; ++i) numbers[i] += numbers[i + width];
  }
  return numbers[0];
}

/// Splits the rows from `row` on into blocks and calls f.template operator()<n>(begin) for each
/// block of n rows. Blocks have `block` rows; the last ones have fewer.
template <int block = most_rows, class F>
void in_blocks(std::int64_t rows, const F& f, std::int64_t row = 0) {
  for (; rows - row >= block; row += block) f.template operator()<block>(row);
  if constexpr (block > 1) in_blocks<block - 1>(rows, f, row);
}

/// Computes `outputs` numbers of y for each of `rows` rows of x. The loops are unrolled so that GCC
/// keeps the sums in registers.
template <class T, int rows, int outputs>
void dot_products(std::int64_t inputs, const T* weight, const T* bias, Rows<const T> x, T* y,
                  std::int64_t y_stride) {
  Vector<T> sums[rows * outputs];
#pragma GCC unroll 64
  for (Vector<T>& sum : sums) sum = Vector<T>{};
  for (std::int64_t i = 0; i < inputs; i += lanes<T>) {
    Vector<T> w[outputs];
#pragma GCC unroll 8
    for (int j = 0; j < outputs; ++j) w[j] = load(weight + j * inputs + i);
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
      const Vector<T> from = load(x.row(r) + i);
#pragma GCC unroll 8
      for (int j = 0; j < outputs; ++j) sums[r * outputs + j] += w[j] * from;
    }
  }
#pragma GCC unroll 64
  for (int k = 0; k < rows * outputs; ++k) {
    y[k / outputs * y_stride + k % outputs] = sum_of<T>(sums[k]) + bias[k % outputs];
  }
}

template <class T, int rows>
void propagate_rows(const LayerSize& size, const T* weight, const T* bias, Rows<const T> x,
                    Rows<T> y) {
  const std::int64_t inputs = size.held_inputs;
  std::int64_t j = 0;
  for (; j + side_by_side <= size.outputs; j += side_by_side) {
    dot_products<T, rows, side_by_side>(inputs, weight + j * inputs, bias + j, x, y.data + j,
                                        y.stride);
  }
  for (; j < size.outputs; ++j) {
    dot_products<T, rows, 1>(inputs, weight + j * inputs, bias + j, x, y.data + j, y.stride);
  }
}

/// dx += dy W for the first `outputs` columns of dy and the same number of rows of the weight W.
template <class T, int rows, int outputs>
void add_weight_rows(std::int64_t inputs, const T* weight, const T* dy, std::int64_t dy_stride,
                     Rows<T> dx) {
  Vector<T> factors[rows * outputs];
#pragma GCC unroll 64
  for (int k = 0; k < rows * outputs; ++k) {
    factors[k] = Vector<T>{} + dy[k / outputs * dy_stride + k % outputs];
  }
  for (std::int64_t i = 0; i < inputs; i += lanes<T>) {
    Vector<T> w[outputs];
#pragma GCC unroll 8
    for (int j = 0; j < outputs; ++j) w[j] = load(weight + j * inputs + i);
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
      Vector<T> sum = load(dx.row(r) + i);
#pragma GCC unroll 8
      for (int j = 0; j < outputs; ++j) sum += factors[r * outputs + j] * w[j];
      store(dx.row(r) + i, sum);
    }
  }
}

/// Range of a layer's outputs, which are rows of its weight.
struct OutputRange {
  std::int64_t begin;
  std::int64_t end;
};

/// Calls passed(outputs) for each group of weight rows right after reading it, while it is in the
/// cache.
template <class T, int rows, class F>
void propagate_rows_back(const LayerSize& size, const T* weight, Rows<const T> dy, Rows<T> dx,
                         const F& passed) {
  const std::int64_t inputs = size.held_inputs;
  for (int r = 0; r < rows; ++r) std::fill_n(dx.row(r), inputs, T{0});
  std::int64_t j = 0;
  for (; j + side_by_side <= size.outputs; j += side_by_side) {
    add_weight_rows<T, rows, side_by_side>(inputs, weight + j * inputs, dy.data + j, dy.stride, dx);
    passed(OutputRange{j, j + side_by_side});
  }
  for (; j < size.outputs; ++j) {
    add_weight_rows<T, rows, 1>(inputs, weight + j * inputs, dy.data + j, dy.stride, dx);
    passed(OutputRange{j, j + 1});
  }
}

/// Takes one step of Adam for `vectors` vectors of a row of a weight. Their gradient is the sum of
/// the rows of x, each times its factor.
template <class T, int vectors>
void take_vectors(const AdamUpdate<T>& update, const std::vector<T>& factors, Rows<const T> x,
                  const TrainedWeight<T>& w) {
  Vector<T> gradients[vectors] = {};
  for (std::size_t r = 0; r < factors.size(); ++r) {
    const T* const row = x.row(static_cast<std::int64_t>(r));
#pragma GCC unroll 8
    for (int k = 0; k < vectors; ++k) gradients[k] += factors[r] * load(row + k * lanes<T>);
  }
#pragma GCC unroll 8
  for (int k = 0; k < vectors; ++k) {
    const std::int64_t at = k * lanes<T>;
    Vector<T> value = load(w.values + at);
    Vector<T> first_moment = load(w.first_moment + at);
    Vector<T> second_moment = load(w.second_moment + at);
    update(gradients[k], value, first_moment, second_moment);
    store(w.values + at, value);
    store(w.first_moment + at, first_moment);
    store(w.second_moment + at, second_moment);
  }
}

template <class T>
TrainedWeight<T> from(const TrainedWeight<T>& weight, std::int64_t begin) {
  return {weight.values + begin, weight.first_moment + begin, weight.second_moment + begin};
}

/// take() for some rows of the weight; `factors` is scratch space with one number per row of the
/// batch.
template <class T>
void take_rows(const AdamUpdate<T>& update, T scale, const LayerSize& size, OutputRange outputs,
               Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight,
               std::vector<T>& factors) {
  const DenormalsAreZero guard;  // see adam.cpp
  for (std::int64_t j = outputs.begin; j < outputs.end; ++j) {
    for (std::size_t r = 0; r < factors.size(); ++r) {
      factors[r] = scale * dy.row(static_cast<std::int64_t>(r))[j];
    }
    in_blocks<adam_vectors>(size.held_inputs / lanes<T>, [&]<int vectors>(std::int64_t first) {
      const std::int64_t i = first * lanes<T>;
      take_vectors<T, vectors>(update, factors, {x.data + i, x.stride},
                               from(weight, j * size.held_inputs + i));
    });
  }
}

/// Computes the products of one row with `rows` others, each summed from its first number to its
/// last. Sums several rows at the same time, because each addition waits for the previous one.
template <class T, int rows>
void dot_row(std::int64_t count, const T* row, Rows<const T> others, double* products) {
  double sums[rows] = {};
  for (std::int64_t i = 0; i < count; ++i) {
    const auto number = static_cast<double>(row[i]);
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) sums[r] += number * others.data[r * others.stride + i];
  }
  std::copy_n(sums, rows, products);
}

/// Computes the products of row r of x with the rows 0 to r.
template <class T>
void dot_with_earlier(std::int64_t count, Rows<const T> x, std::int64_t r, double* products) {
  in_blocks(r + 1, [&]<int block>(std::int64_t first) {
    dot_row<T, block>(count, x.row(r), x.from(first), products + first);
  });
}

}  // namespace

template <class T>
void propagate(const LayerSize& size, const T* weight, const T* bias, std::int64_t rows,
               Rows<const T> x, Rows<T> y) {
  in_blocks(rows, [&]<int block>(std::int64_t row) {
    propagate_rows<T, block>(size, weight, bias, x.from(row), y.from(row));
  });
}

template <class T>
void propagate_back(const LayerSize& size, const T* weight, std::int64_t rows, Rows<const T> dy,
                    Rows<T> dx) {
  in_blocks(rows, [&]<int block>(std::int64_t row) {
    propagate_rows_back<T, block>(size, weight, dy.from(row), dx.from(row), [](OutputRange) {});
  });
}

template <class T>
void propagate_back_and_take(const AdamStep& step, const LayerSize& size, std::int64_t rows,
                             Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight,
                             Rows<T> dx) {
  if (rows > most_rows) {
    propagate_back<T>(size, weight.values, rows, dy, dx);
    take<T>(step, 1, size, rows, dy, x, weight);
    return;
  }
  const AdamUpdate<T> update(step);
  std::vector<T> factors(static_cast<std::size_t>(rows));
  in_blocks(rows, [&]<int block>(std::int64_t) {
    propagate_rows_back<T, block>(size, weight.values, dy, dx, [&](OutputRange outputs) {
      take_rows<T>(update, 1, size, outputs, dy, x, weight, factors);
    });
  });
}

template <class T>
void take(const AdamStep& step, double scale, const LayerSize& size, std::int64_t rows,
          Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight) {
  std::vector<T> factors(static_cast<std::size_t>(rows));
  take_rows<T>(AdamUpdate<T>(step), static_cast<T>(scale), size, {0, size.outputs}, dy, x, weight,
               factors);
}

template <class T>
double squared_norm(const LayerSize& size, std::int64_t rows, Rows<const T> dy, Rows<const T> x) {
  std::vector<double> of_dy(static_cast<std::size_t>(rows));
  std::vector<double> of_x(static_cast<std::size_t>(rows));
  double sum = 0;
  for (std::int64_t r = 0; r < rows; ++r) {
    dot_with_earlier(size.outputs, dy, r, of_dy.data());
    dot_with_earlier(size.held_inputs, x, r, of_x.data());
    for (std::int64_t s = 0; s <= r; ++s) {
      const auto i = static_cast<std::size_t>(s);
      sum += (r == s ? 1 : 2) * of_dy[i] * of_x[i];
    }
  }
  return sum;
}

#define PIAE_INSTANTIATE(T)                                                                       \
  template void propagate(const LayerSize&, const T*, const T*, std::int64_t, Rows<const T>,      \
                          Rows<T>);                                                               \
  template void propagate_back(const LayerSize&, const T*, std::int64_t, Rows<const T>, Rows<T>); \
  template void take(const AdamStep&, double, const LayerSize&, std::int64_t, Rows<const T>,      \
                     Rows<const T>, const TrainedWeight<T>&);                                     \
  template void propagate_back_and_take(const AdamStep&, const LayerSize&, std::int64_t,          \
                                        Rows<const T>, Rows<const T>, const TrainedWeight<T>&,    \
                                        Rows<T>);                                                 \
  template double squared_norm(const LayerSize&, std::int64_t, Rows<const T>, Rows<const T>)
PIAE_INSTANTIATE(float);
PIAE_INSTANTIATE(double);

}  // namespace piae::nets
