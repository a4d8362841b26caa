#pragma once

#include <cstdint>

#include "nets/adam.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// A network that is trained on one core, with gradients that are written by hand.
///
/// A training step: fill input(); call forward(); fill output_gradient(); call backward(), which
/// returns the gradient by the input where that is asked for; call squared_norm() if the gradients
/// are to be clipped; call take().
template <class T>
class Network {
 public:
  Network() = default;
  virtual ~Network() = default;
  // A copy would train the same parameters as the original, which nobody would expect.
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// [most_rows, inputs]: the caller fills the rows of its batch. The numbers that fill a row up to
  /// whole vectors must stay zero.
  virtual Rows<T> input() = 0;
  /// The output [rows, outputs] for the first `rows` rows of input().
  virtual Rows<const T> forward(std::int64_t rows) = 0;

  /// [most_rows, outputs]: the caller fills in the gradient of its loss by the output.
  virtual Rows<T> output_gradient() = 0;
  /// Propagates output_gradient() back, after forward(rows). With more than one signal,
  /// output_gradient() holds the gradients of several losses of the same batch, one below the
  /// other: [signals * rows, outputs]. Returns the gradients by the input for the rows `by_input`
  /// of these [signals * rows]. The parameters follow the first signal alone.
  virtual Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) = 0;

  /// The squared Euclidean norm of the gradients of all parameters together, by the first signal.
  [[nodiscard]] virtual double squared_norm() const = 0;
  /// One step of Adam by these gradients times `scale`.
  virtual void take(const AdamStep& step, double scale) = 0;
};

}  // namespace piae::nets
