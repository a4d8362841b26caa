#pragma once

#include <cstdint>

#include "nets/adam.hpp"

namespace piae::nets {

/// Rows of numbers; row i begins at data + i * stride. Rows are filled up with zeros to whole
/// vectors (base/vector.hpp), and so are strides.
template <class T>
struct Rows {
  T* data;
  std::int64_t stride;

  [[nodiscard]] T* row(std::int64_t i) const { return data + i * stride; }
  [[nodiscard]] Rows from(std::int64_t i) const { return {row(i), stride}; }
  operator Rows<const T>() const { return {data, stride}; }
};

/// Sizes of a dense layer; its weight is [outputs, held_inputs].
struct LayerSize {
  std::int64_t inputs;
  std::int64_t outputs;
  std::int64_t held_inputs;  ///< inputs, filled up with zeros to whole vectors
};

// Passes over the weight of a dense layer for batches of a few rows. Each reads the weight once for
// up to six rows: at batch 5 that traffic is what training waits for. The result of a row does not
// depend on the rows beside it.

/// y = x W^T + b for x [rows, inputs] and y [rows, outputs].
template <class T>
void propagate(const LayerSize& size, const T* weight, const T* bias, std::int64_t rows,
               Rows<const T> x, Rows<T> y);

/// dx = dy W: the gradient by the layer's input, all held columns of it.
template <class T>
void propagate_back(const LayerSize& size, const T* weight, std::int64_t rows, Rows<const T> dy,
                    Rows<T> dx);

/// A layer's weight with Adam's moments, each [outputs, held_inputs].
template <class T>
struct TrainedWeight {
  T* values;
  T* first_moment;
  T* second_moment;
};

/// One step of Adam with the gradient scale * dy^T x, of which no number is ever stored: it has the
/// rank of the batch, and is formed where it is used.
template <class T>
void take(const AdamStep& step, double scale, const LayerSize& size, std::int64_t rows,
          Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight);

/// Squared Euclidean norm of dy^T x, by the products of its rows: sum_rs (dy_r . dy_s)(x_r . x_s).
template <class T>
double squared_norm(const LayerSize& size, std::int64_t rows, Rows<const T> dy, Rows<const T> x);

}  // namespace piae::nets
