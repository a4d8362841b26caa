#pragma once

#include <cstdint>

#include "nets/rows.hpp"

namespace piae::nets {

// Gates of a recurrent layer at one frame (Cho et al. 2014, in LibTorch's form):
//
//   r = sigmoid(x_r + h_r)     how much of the state the candidate sees
//   z = sigmoid(x_z + h_z)     how much of the state is kept
//   n = tanh(x_n + r h_n)      the candidate
//   h' = (1 - z) n + z h       the state after the frame
//
// Here x = W_x input + b_x depends on the input, and h_* = W_h h + b_h on the previous state.
// `units` must be a multiple of row_granule.

/// One frame forward, for all rows of a batch.
template <class T>
struct GatesForward {
  std::int64_t rows;
  std::int64_t units;
  Rows<const T> x;        ///< [rows, 3 units]: x_r, x_z, x_n
  Rows<const T> product;  ///< [rows, 3 units]: W_h h
  const T* state_bias;    ///< [3 units]: b_h
  Rows<const T> before;   ///< [rows, units]: h
  Rows<T> gates;          ///< [rows, 4 units] gets r, z, n and h_n
  Rows<T> state;          ///< [rows, units] gets h'
};
template <class T>
void open_gates(const GatesForward<T>& frame);

/// One frame backward, for all rows of a signal.
template <class T>
struct GatesBackward {
  std::int64_t rows;
  std::int64_t units;
  Rows<const T> gates;     ///< [rows, 4 units], from open_gates()
  Rows<const T> before;    ///< [rows, units]: h
  Rows<const T> by_state;  ///< [rows, units]: the direct gradient of the loss by h'
  Rows<T> carried;     ///< [rows, units]: the gradient by h' through later frames; replaced by the
                       ///< part of the gradient by h that does not pass through W_h
  Rows<T> by_x;        ///< [rows, 3 units] gets the gradient by x
  Rows<T> by_product;  ///< [rows, 3 units] gets the gradient by W_h h, which is also that by b_h
};
template <class T>
void differentiate_gates(const GatesBackward<T>& frame);

}  // namespace piae::nets
