#pragma once

#include <cstdint>
#include <memory>

#include "nets/network.hpp"

namespace piae::nets {

/// Two networks, one behind the other, with ReLU between them. What the first gives is a matrix a
/// row, and the second is given the transposed one: convolutions have their channels side by side,
/// [time, channel], while the dense layer beside them has one channel after the other.
template <class T>
class JoinedNetworks final : public Network<T> {
 public:
  /// `first` gives [height, width] numbers a row, and `second` takes as many.
  JoinedNetworks(std::unique_ptr<Network<T>> first, std::int64_t height, std::int64_t width,
                 std::unique_ptr<Network<T>> second);

  Rows<T> input() override { return first_->input(); }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return second_->output_gradient(); }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;
  [[nodiscard]] double squared_norm() const override;
  void take(const AdamStep& step, double scale) override;

 private:
  std::unique_ptr<Network<T>> first_;
  std::int64_t height_;
  std::int64_t width_;
  std::unique_ptr<Network<T>> second_;
};

extern template class JoinedNetworks<float>;
extern template class JoinedNetworks<double>;

}  // namespace piae::nets
