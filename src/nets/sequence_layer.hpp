#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

namespace piae::nets {

/// Shape of a sequence in time: `length` positions with `width` numbers each, stored position by
/// position. Widths are whole rows (base/vector.hpp), padded with zeros. Layers that accept or
/// return other widths document them.
struct SequenceShape {
  std::int64_t length;
  std::int64_t width;

  [[nodiscard]] std::int64_t size() const { return length * width; }
  bool operator==(const SequenceShape&) const = default;
};

/// The number of windows of a batch, and the number of losses whose gradients are propagated back.
struct SignalBatch {
  std::int64_t windows;
  std::int64_t signals;

  /// Returns the number of windows that hold gradients: those of each signal, one after the other.
  [[nodiscard]] std::int64_t all() const { return windows * signals; }
};

/// A layer of a network on sequences. It keeps the results of its last forward() that backward()
/// needs, except the input, which both functions receive. Arrays hold the sequences of all windows,
/// one after the other.
template <class T>
class SequenceLayer {
 public:
  SequenceLayer(const SequenceShape& input, const SequenceShape& output)
      : input_(input), output_(output) {}
  explicit SequenceLayer(const std::pair<SequenceShape, SequenceShape>& input_and_output)
      : SequenceLayer(input_and_output.first, input_and_output.second) {}
  virtual ~SequenceLayer() = default;
  SequenceLayer(const SequenceLayer&) = delete;
  SequenceLayer& operator=(const SequenceLayer&) = delete;

  [[nodiscard]] const SequenceShape& input() const { return input_; }
  [[nodiscard]] const SequenceShape& output() const { return output_; }

  /// x [windows, input] -> y [windows, output].
  virtual void forward(std::int64_t windows, const T* x, T* y) = 0;

  /// Computes the gradients by the input, dx [signals, windows, input], from the gradients dy
  /// [signals, windows, output]. dx is null if they are not needed. x [windows, input] is that of
  /// the last forward(). The gradients of the layer's parameters become those of the first signal.
  virtual void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) = 0;

 private:
  SequenceShape input_;
  SequenceShape output_;
};

/// A matrix with one position per row.
template <class T>
using RowMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns a view of rows of numbers without gaps.
template <class T>
Eigen::Map<const RowMatrix<T>> as_matrix(const T* data, std::int64_t rows, std::int64_t columns) {
  return {data, rows, columns};
}
template <class T>
Eigen::Map<RowMatrix<T>> as_matrix(T* data, std::int64_t rows, std::int64_t columns) {
  return {data, rows, columns};
}

/// Returns the start of an array, enlarged to `size` numbers if necessary. Enlarging discards the
/// contents.
template <class T>
T* room_for(std::int64_t size, Eigen::ArrayX<T>& numbers) {
  if (numbers.size() < size) numbers.resize(size);
  return numbers.data();
}

}  // namespace piae::nets
