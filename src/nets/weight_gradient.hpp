#pragma once

#include <cstdint>

#include "nets/rows.hpp"

namespace piae::nets {

/// The gradients of a dense layer's weight and bias, dy^T x [outputs, held inputs] and the sum of
/// the rows of dy [outputs], for dy [rows, outputs] and x [rows, held inputs].
template <class T>
void set_weight_gradient(Rows<const T> dy, Rows<const T> x, std::int64_t rows, std::int64_t outputs,
                         std::int64_t held_inputs, T* gradient);
template <class T>
void set_bias_gradient(Rows<const T> dy, std::int64_t rows, std::int64_t outputs, T* gradient);

}  // namespace piae::nets
