#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of `piae-dt-transformer`, which the paper's outlook names: blocks of a
/// Transformer's encoder (Vaswani et al. 2017). Each network has `depth` layers: one dense layer,
/// and blocks. A block is self-attention with four heads, then two dense layers with ReLU between
/// them, 4 times as wide as in Vaswani et al. Our choices, and why:
///
/// - A token is a frame of 32 samples, as in `piae-dt-rnn`; a dense layer converts it to 32 numbers
/// and back.
/// - Both parts of a block get their input after layer normalisation, x + F(LN(x)), with one more
/// at the end (pre-norm, Xiong et al. 2020). Vaswani's LN(x + F(x)) needs a learning rate that
/// first rises, unlike the paper's.
/// - Positions are learned (Gehring et al. 2017), which Vaswani et al. found as good as sinusoids
/// (their Table 3, row E). A window has so few frames that most of the sinusoids would hardly
/// change.
/// - The encoder averages over the frames, and a dense layer computes (k~, c~) from the mean: these
/// hold for the whole window. The decoder gets (k~, c~, label) at each frame; frames differ only by
/// the position, like those of `piae-dt-rnn` by the state.
/// - The projections of the attention have no biases, as in Vaswani et al.: a bias of the keys
/// would change nothing, and Adam would make steps from the rounding errors of its gradient.
/// - No dropout, which would make (k~, c~) random, and no mask: the window is given whole.
///
/// At 1024 samples, 10 classes and depth 3, encoder and decoder have 55 074 parameters (39 235 in
/// `piae-dt-cnn`, 184 162 in `piae-dt-rnn`) and 1.9e6 multiplications per window (0.6e6 in
/// `piae-dt-cnn`; 1.1e6 in the module).
class TransformerCoder final : public SequenceCoder<TransformerCoder> {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples of a token
  static constexpr std::int64_t width = 32;  ///< numbers of a token
  static constexpr std::int64_t heads = 4;
  /// Each token attends to each token: 1024 tokens need 17 MB per block and window.
  static constexpr std::int64_t most_tokens = 1024;
  static constexpr std::int64_t inner_width = 4 * width;  ///< between the two dense layers

  /// Throws Error(usage) if there are fewer than two layers, if the window is not a whole number of
  /// frames, or if it has more than most_tokens frames.
  TransformerCoder(const NetworkShape& shape, const TwinOptions& options);

  /// Block i has the parameters <network>/block<i>/...: attention/norm, attention/projections (of
  /// queries, keys and values, in this order), attention/output, dense/norm, dense/inner and
  /// dense/output.
  [[nodiscard]] std::int64_t blocks() const { return blocks_; }

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

 private:
  NetworkShape shape_;
  std::int64_t blocks_;
  std::int64_t tokens_;
};

}  // namespace piae::twin
