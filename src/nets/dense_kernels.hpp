#pragma once

#include <cstdint>

#include "nets/adam.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// The sizes of a dense layer. Its weight lies in memory as [outputs, held_inputs].
struct LayerSize {
  std::int64_t inputs;
  std::int64_t outputs;
  std::int64_t held_inputs;  ///< inputs, rounded up to whole vectors; zeros fill the difference
};

// The functions below go over the weight of a dense layer for a batch of a few rows. Each reads the
// weight once for up to six rows, because at the paper's batch of 5 the training waits for this
// reading. What a row of the batch gives does not depend on the rows beside it.

/// y = x W^T + b for x [rows, inputs] and y [rows, outputs].
template <class T>
void propagate(const LayerSize& size, const T* weight, const T* bias, std::int64_t rows,
               Rows<const T> x, Rows<T> y);

/// dx = dy W: from the gradient by the output to that by the input, for all held columns.
template <class T>
void propagate_back(const LayerSize& size, const T* weight, std::int64_t rows, Rows<const T> dy,
                    Rows<T> dx);

/// The weight of a layer with the moments that Adam keeps of it, each [outputs, held_inputs].
template <class T>
struct TrainedWeight {
  T* values;
  T* first_moment;
  T* second_moment;
};

/// One step of Adam with the gradient scale * dy^T x. The gradient is never stored: each row of it
/// is a sum of a few rows of x, formed where it is used.
template <class T>
void take(const AdamStep& step, double scale, const LayerSize& size, std::int64_t rows,
          Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight);

/// propagate_back() and then take() with a scale of 1, in one pass over the weight.
template <class T>
void propagate_back_and_take(const AdamStep& step, const LayerSize& size, std::int64_t rows,
                             Rows<const T> dy, Rows<const T> x, const TrainedWeight<T>& weight,
                             Rows<T> dx);

/// The squared Euclidean norm of dy^T x, computed as sum over r and s of (dy_r . dy_s)(x_r . x_s)
/// so that dy^T x itself is not needed.
template <class T>
double squared_norm(const LayerSize& size, std::int64_t rows, Rows<const T> dy, Rows<const T> x);

}  // namespace piae::nets
