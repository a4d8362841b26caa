#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nets/gru_layer.hpp"
#include "nets/network.hpp"
#include "nets/parameters.hpp"
#include "nets/transposed_weight.hpp"

namespace piae::nets {

/// Of how many frames the input and the output of a recurrent chain consist. Each is either the
/// length of the sequence or 1: an input of one frame is given at each frame of the sequence, an
/// output of one frame is made of the last state alone.
struct FrameCounts {
  std::int64_t input;
  std::int64_t output;
};

/// Layers of gated recurrent units over the frames of a sequence, and a dense layer that makes
/// numbers of the last one's state. A row of input() or of the output holds its frames one after
/// the other.
template <class T>
class RecurrentChain final : public Network<T> {
 public:
  /// A chain over the parameters <name>/gru0/..., <name>/gru1/..., ..., <name>/dense/...
  /// (recurrent_specs.hpp), for batches of up to `most_rows` rows. Throws std::logic_error when
  /// there are no such parameters; later calls throw it for more rows.
  RecurrentChain(std::shared_ptr<Parameters<T>> parameters, const std::string& name,
                 FrameCounts frames, std::int64_t most_rows);

  Rows<T> input() override { return rows_of(input_, most_rows_); }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return rows_of(output_gradient_, most_rows_); }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;

  [[nodiscard]] double squared_norm() const override;
  void take(const AdamStep& step, double scale) override;

 private:
  using Numbers = Eigen::ArrayX<T>;  // begins at the boundary of a vector register
  using Kept = typename Parameters<T>::Kept;

  static Rows<T> rows_of(Numbers& numbers, std::int64_t count) {
    return {numbers.data(), numbers.size() / count};
  }
  [[nodiscard]] const T* values() const { return parameters_->data(Kept::value) + begin_; }
  void require_room_for(std::int64_t rows) const;
  [[nodiscard]] Rows<const T> inputs_of(std::size_t layer) const;
  /// The states that the dense layer reads.
  [[nodiscard]] Rows<const T> read_states(std::int64_t rows) const;
  /// From output_gradient() from row `first` on back to the first layer. The gradients of the
  /// parameters are set where this is wanted.
  void propagate_back(std::int64_t first, std::int64_t rows, bool with_parameters);

  std::shared_ptr<Parameters<T>> parameters_;
  FrameCounts frames_;
  std::int64_t most_rows_;
  std::vector<GruLayer<T>> layers_;
  typename Parameters<T>::Parameter dense_weight_;
  TransposedWeight<T> dense_;
  std::int64_t inputs_;      ///< of a frame
  std::int64_t begin_;       ///< of the chain's parameters among all
  std::int64_t dense_bias_;  ///< where it begins, from begin_ on
  Numbers gradients_;        ///< of the chain's parameters, by the first signal

  Numbers input_;            ///< [most_rows, input frames * inputs], as the caller sees it
  Numbers output_;           ///< [most_rows, output frames * outputs]
  Numbers output_gradient_;  ///< [most_rows, output frames * outputs]
  Numbers input_gradient_;   ///< [most_rows, input frames * inputs]
  // The same frame by frame, as the layers see it: [frames rows, ...].
  Numbers input_frames_;
  Numbers output_frames_;
  Numbers output_gradient_frames_;
  Numbers input_gradient_frames_;
  std::vector<Rows<const T>> states_;  ///< of each layer, as the last forward() left them
};

extern template class RecurrentChain<float>;
extern template class RecurrentChain<double>;

}  // namespace piae::nets
