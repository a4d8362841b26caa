#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of `piae-dt-transformer`, which the paper's outlook names: blocks of a
/// Transformer's encoder (Vaswani et al. 2017). Each has `depth` layers, of which all but one are
/// blocks of self-attention with four heads and of two dense layers with ReLU between them, 4 times
/// as wide as there. What is chosen here, and why:
///
/// - A token is a frame of 32 samples, as `piae-dt-rnn` reads windows; a dense layer turns it into
///   32 numbers and back.
/// - Both parts of a block are given their input after layer normalisation, x + F(LN(x)), with one
///   more at the end (pre-norm, Xiong et al. 2020); with Vaswani's LN(x + F(x)) training needs a
///   learning rate that first rises, which the paper's has not.
/// - Positions are learned (Gehring et al. 2017), which Vaswani et al. found as good as sinusoids
///   (their Table 3, row E). There are as few as frames in a window, for which most of the
///   sinusoids would hardly change.
/// - The encoder takes the mean over the frames, from which a dense layer makes (k~, c~): these
///   hold for the whole window. The decoder is given (k~, c~, label) at each frame, and differs
///   from frame to frame by the position alone, as that of `piae-dt-rnn` by its state.
/// - The projections of the attention have no biases, as there: one of the keys would change
///   nothing, so that Adam would make steps of what rounding leaves of its gradient.
/// - No dropout, which would make (k~, c~) random, and no mask: a window is given whole.
///
/// At 1024 samples, 10 classes and depth 3, encoder and decoder have 55 074 parameters (39 235 in
/// `piae-dt-cnn`, 184 162 in `piae-dt-rnn`) and 1.9e6 products of numbers a window (0.6e6; the
/// module has 1.1e6).
class TransformerCoder final : public SequenceCoder<TransformerCoder> {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples of a token
  static constexpr std::int64_t width = 32;  ///< numbers of a token
  static constexpr std::int64_t heads = 4;
  /// Each token attends to each: of so many a window takes 17 MB in a block.
  static constexpr std::int64_t most_tokens = 1024;
  static constexpr std::int64_t inner_width = 4 * width;  ///< between the two dense layers

  /// Throws Error(usage) for fewer than two layers, and for a window that is not a whole number of
  /// frames, or has more than most_tokens of them.
  TransformerCoder(const NetworkShape& shape, const TwinOptions& options);

  /// Block i has the parameters <network>/block<i>/...: attention/norm, attention/projections (of
  /// queries, keys and values, one below the other), attention/output, dense/norm, dense/inner and
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
