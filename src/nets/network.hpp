#pragma once

#include <cstdint>

#include "nets/adam.hpp"
#include "nets/rows.hpp"

namespace piae::nets {

/// A network that is trained on one core, with hand-written gradients.
///
/// A training step: fill input(); call forward(); fill output_gradient(); call backward(), which
/// returns the gradient by the input for the requested rows; call squared_norm() if the gradients
/// are to be clipped; call take().
template <class T>
class Network {
 public:
  Network() = default;
  virtual ~Network() = default;
  // A copy would train the same parameters as the original.
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Returns [most_rows, inputs]: the caller fills the rows of its batch. The padding of a row to
  /// whole vectors must stay zero.
  virtual Rows<T> input() = 0;
  /// Returns the output [rows, outputs] for the first `rows` rows of input().
  virtual Rows<const T> forward(std::int64_t rows) = 0;

  /// Returns [most_rows, outputs]: the caller fills in the gradient of its loss by the output.
  virtual Rows<T> output_gradient() = 0;
  /// Propagates output_gradient() back, after forward(rows). With more than one signal,
  /// output_gradient() holds the gradients of several losses of the same batch, one after the
  /// other: [signals * rows, outputs]. Returns the gradients by the input for the rows `by_input`
  /// of these [signals * rows]. The gradients of the parameters are those of the first signal only.
  virtual Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) = 0;

  /// Returns the squared Euclidean norm of the gradients of all parameters, for the first signal.
  [[nodiscard]] virtual double squared_norm() const = 0;
  /// Takes one step of Adam with these gradients times `scale`.
  virtual void take(const AdamStep& step, double scale) = 0;
};

}  // namespace piae::nets
