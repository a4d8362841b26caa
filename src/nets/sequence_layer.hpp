#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

namespace piae::nets {

/// Numbers that follow each other in time: `length` positions with `width` numbers each, position
/// by position. Widths are whole rows (base/vector.hpp), and zeros fill up what is narrower, but
/// where a layer says that it takes or gives others.
struct SequenceShape {
  std::int64_t length;
  std::int64_t width;

  [[nodiscard]] std::int64_t size() const { return length * width; }
  bool operator==(const SequenceShape&) const = default;
};

/// How many windows a batch has, and the gradients of how many losses go back through them.
struct SignalBatch {
  std::int64_t windows;
  std::int64_t signals;

  /// Windows in which the gradients are held: those of each signal, one below the other.
  [[nodiscard]] std::int64_t all() const { return windows * signals; }
};

/// A layer of a network on sequences. It keeps what backward() needs of its last forward(), but for
/// its input, which is given to both. Arrays hold the sequences of all windows, one after the
/// other.
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

  /// From the gradients dy [signals, windows, output] to those by the input, dx [signals, windows,
  /// input], which is null where nobody asks. x [windows, input] is that of the last forward(). The
  /// gradients of the layer's parameters become those of the first signal.
  virtual void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) = 0;

 private:
  SequenceShape input_;
  SequenceShape output_;
};

/// One position a row.
template <class T>
using RowMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A view of rows of numbers without gaps.
template <class T>
Eigen::Map<const RowMatrix<T>> as_matrix(const T* data, std::int64_t rows, std::int64_t columns) {
  return {data, rows, columns};
}
template <class T>
Eigen::Map<RowMatrix<T>> as_matrix(T* data, std::int64_t rows, std::int64_t columns) {
  return {data, rows, columns};
}

/// The beginning of an array that has room for `size` numbers afterwards. What it held is lost
/// where it had not.
template <class T>
T* room_for(std::int64_t size, Eigen::ArrayX<T>& numbers) {
  if (numbers.size() < size) numbers.resize(size);
  return numbers.data();
}

}  // namespace piae::nets
