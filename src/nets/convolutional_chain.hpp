#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nets/convolution_layer.hpp"
#include "nets/network.hpp"
#include "nets/padded_batch.hpp"

namespace piae::nets {

/// A chain of strided or of transposed convolutions with ReLU between them. A row of input and
/// output is a signal [time, channel].
template <class T>
class ConvolutionalChain final : public Network<T> {
 public:
  /// A chain over the parameters <name>/conv0/weight, <name>/conv0/bias, <name>/conv1/weight, ...,
  /// for signals of `input_length` times in batches of up to `most_rows` rows. Throws
  /// std::logic_error when no parameter has such a name, and for what ConvolutionLayer refuses;
  /// later calls throw it for more rows.
  ConvolutionalChain(const std::shared_ptr<Parameters<T>>& parameters, const std::string& name,
                     ConvolutionKind kind, std::int64_t input_length, std::int64_t most_rows);

  Rows<T> input() override { return signals_.front().rows(); }
  Rows<const T> forward(std::int64_t rows) override;
  Rows<T> output_gradient() override { return gradients_.back().rows(); }
  Rows<const T> backward(std::int64_t rows, std::int64_t signals, RowRange by_input) override;
  [[nodiscard]] double squared_norm() const override;
  void take(const AdamStep& step, double scale) override;

 private:
  void require_room_for(std::int64_t rows) const;

  std::int64_t most_rows_;
  std::vector<ConvolutionLayer<T>> layers_;
  // The input of layer i is number i, and its output number i + 1, after ReLU where one follows.
  std::vector<PaddedBatch<T>> signals_;
  std::vector<PaddedBatch<T>> gradients_;  ///< by them
};

extern template class ConvolutionalChain<float>;
extern template class ConvolutionalChain<double>;

}  // namespace piae::nets
