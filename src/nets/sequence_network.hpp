#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "nets/gradient_array.hpp"
#include "nets/network.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// A network of layers on sequences. It has few weights and uses them at each position, so
/// arithmetic dominates a step, and the gradients are stored.
template <class T>
class SequenceNetwork final : public Network<T> {
 public:
  /// Makes a network for batches of up to `most_rows` rows. `layers` use parameters of
  /// `parameters`. Later calls throw std::logic_error for more rows.
  SequenceNetwork(std::unique_ptr<GradientArray<T>> parameters,
                  std::unique_ptr<SequenceLayer<T>> layers, std::int64_t most_rows);

  Rows<T> input() override { return {input_.data(), layers_->input().size()}; }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return {output_gradient_.data(), layers_->output().size()}; }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;

  [[nodiscard]] double squared_norm() const override { return parameters_->squared_norm(); }
  void take(const AdamStep& step, double scale) override { parameters_->take(step, scale); }

 private:
  void require_room_for(std::int64_t rows) const;

  std::unique_ptr<GradientArray<T>> parameters_;
  std::unique_ptr<SequenceLayer<T>> layers_;
  std::int64_t most_rows_;
  Eigen::ArrayX<T> input_;
  Eigen::ArrayX<T> output_;
  Eigen::ArrayX<T> output_gradient_;
  Eigen::ArrayX<T> input_gradient_;
};

extern template class SequenceNetwork<float>;
extern template class SequenceNetwork<double>;

}  // namespace piae::nets
