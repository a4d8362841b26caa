#pragma once

#include <cstdint>

#include "nets/adam.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// Sizes of a dense layer. Its weight is stored as [outputs, held_inputs].
struct LayerSize {
  std::int64_t inputs;
  std::int64_t outputs;
  std::int64_t held_inputs;  ///< inputs, rounded up to whole vectors; the padding is zero
};

// The functions below process the weight of a dense layer for a batch of a few rows. Each reads the
// weight once for up to six rows, because at the paper's batch of 5 the training waits for this
// reading. The result of a row does not depend on the other rows of the batch.

/// y = x W^T + b for x [rows, inputs] and y [rows, outputs].
template <class T>
void propagate(const LayerSize& size, const T* weight, const T* bias, std::int64_t rows,
               Rows<const T> x, Rows<T> y);

/// dx = dy W: the gradient by the input from the gradient by the output, for all held columns.
template <class T>
void propagate_back(const LayerSize& size, const T* weight, std::int64_t rows, Rows<const T> dy,
                    Rows<T> dx);

/// The weight of a layer and its moments in Adam, each [outputs, held_inputs].
template <class T>
struct TrainedWeight {
  T* values;
  T* first_moment;
  T* second_moment;
};

/// Takes one step of Adam with the gradient scale * dy^T x. The gradient is never stored: each row
/// is a sum of a few rows of x, computed where it is used.
template <class T>
void take(const AdamStep& step, double scale, const LayerSize& size, std::int64_t rows,
          Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight);

/// Does propagate_back() and then take() with a scale of 1, in one pass over the weight.
template <class T>
void propagate_back_and_take(const AdamStep& step, const LayerSize& size, std::int64_t rows,
                             Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight,
                             Rows<T> dx);

/// Returns the squared Euclidean norm of dy^T x, computed as the sum over r and s of (dy_r .
/// dy_s)(x_r . x_s), which avoids computing dy^T x.
template <class T>
double squared_norm(const LayerSize& size, std::int64_t rows, Rows<const T> dy, Rows<const T> x);

}  // namespace piae::nets
