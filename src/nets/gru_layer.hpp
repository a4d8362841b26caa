#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "nets/parameters.hpp"
#include "nets/rows.hpp"
#include "nets/transposed_weight.hpp"

namespace piae::nets {

/// A layer of gated recurrent units over the frames of a sequence, at rest before the first one.
/// All its arrays hold the rows of the batch at frame 0, below them those at frame 1, and so on.
///
/// The products with the inputs, and those that make the gradients, are taken of all frames at
/// once; what is left for each frame is the product with the state.
template <class T>
class GruLayer {
 public:
  /// A layer over the parameters <name>/input_weight and so on (recurrent_specs.hpp). It is given
  /// an input at each of `frames` frames, or, where `input_frames` is 1, the same one at all of
  /// them. Values and gradients are handed in from the number `origin` of all parameters on. Throws
  /// std::logic_error for units that do not fill whole vectors.
  GruLayer(const Parameters<T>& parameters, const std::string& name, std::int64_t origin,
           std::int64_t input_frames, std::int64_t frames, std::int64_t most_rows);

  [[nodiscard]] std::int64_t units() const { return units_; }

  /// The states after each frame [frames rows, units], of inputs [input_frames rows, inputs].
  Rows<const T> forward(const T* values, Rows<const T> inputs, std::int64_t rows);

  /// [frames rows, units]: the caller fills in the gradient of its loss by the states that
  /// forward() returned, as far as it does not pass through later frames.
  T* state_gradient() { return state_gradient_.data(); }
  /// Propagates state_gradient() back through the frames, after forward(rows).
  void backward(const T* values, std::int64_t rows);
  /// Of the last backward(): the gradient by the inputs [input_frames rows, held inputs], and those
  /// by the parameters.
  void differentiate_inputs(const T* values, std::int64_t rows, Rows<T> by_inputs) const;
  void differentiate_parameters(Rows<const T> inputs, std::int64_t rows, T* gradients) const;

 private:
  using Numbers = Eigen::ArrayX<T>;  // begins at the boundary of a vector register
  /// Where a parameter begins, from the origin on.
  struct Places {
    std::int64_t input_weight;
    std::int64_t state_weight;
    std::int64_t input_bias;
    std::int64_t state_bias;
  };

  std::int64_t input_frames_;
  std::int64_t frames_;
  std::int64_t units_;
  std::int64_t held_inputs_;
  Places at_;
  TransposedWeight<T> input_weight_;
  TransposedWeight<T> state_weight_;
  Numbers x_;               ///< [input_frames rows, 3 units]: W_x input + b_x
  Numbers product_;         ///< [rows, 3 units]: W_h h at one frame
  Numbers gates_;           ///< [frames rows, 4 units]: r, z, n and h_n
  Numbers states_;          ///< [(1 + frames) rows, units], at rest first
  Numbers state_gradient_;  ///< [frames rows, units]
  Numbers carried_;         ///< [rows, units]: the gradient by the state through later frames
  Numbers by_x_;            ///< [frames rows, 3 units], then [input_frames rows, 3 units]
  Numbers by_product_;      ///< [frames rows, 3 units]
};

extern template class GruLayer<float>;
extern template class GruLayer<double>;

}  // namespace piae::nets
