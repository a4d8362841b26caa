#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of `piae-dt-tcn`: a temporal convolutional network (Bai, Kolter and Koltun
/// 2018), which the paper's outlook names. Each has `depth` layers, of which all but one are
/// residual blocks of two dilated convolutions along time, as there: o = ReLU(x + F(x)), F =
/// convolution, ReLU, convolution, ReLU. What is chosen here, and why:
///
/// - A position is a frame of 16 samples, which a dense layer turns into the channels and back. One
///   for each sample would cost 16 times as much.
/// - The dilation grows by 4 from block to block, where Bai et al. double it, because there are
///   few. With two blocks a position sees 21 of them, 336 samples, in which each fault of cwru
///   strikes at least twice (that of the outer race least often, once in 112 samples).
/// - Convolutions look to both sides. Theirs are causal, because they predict what comes; a coder
///   is given its window whole.
/// - The encoder takes the mean over the positions, from which a dense layer makes (k~, c~): these
///   hold for the whole window, whatever angle it starts at. In the decoder a dense layer makes all
///   positions of (k~, c~, label), as in `piae-dt-cnn`, since a convolution cannot tell them apart.
/// - No dropout, which would make (k~, c~) random, and no weight normalisation, which is for many
///   blocks. A convolution of 1 tap beside a block is not needed: all have the same channels.
///
/// At 1024 samples, 10 classes and depth 3, encoder and decoder have 52 594 parameters (39 235 in
/// `piae-dt-cnn`, 184 162 in `piae-dt-rnn`) and 1.7e6 products of numbers a window (0.6e6; the
/// module has 1.1e6).
class TemporalCoder final : public SequenceCoder<TemporalCoder> {
 public:
  static constexpr std::int64_t frame = 16;     ///< samples of a position
  static constexpr std::int64_t channels = 32;  ///< numbers of a position
  static constexpr std::int64_t kernel = 3;     ///< taps of a convolution
  static constexpr std::int64_t growth = 4;     ///< of the dilation, from block to block

  /// Throws Error(usage) for fewer than two layers or more than ten, and for a window that is not a
  /// whole number of frames.
  TemporalCoder(const NetworkShape& shape, const TwinOptions& options);

  /// Block i has the parameters <network>/block<i>/conv0/... and conv1/...
  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  [[nodiscard]] static std::int64_t dilation(std::int64_t block);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

 private:
  NetworkShape shape_;
  std::int64_t blocks_;
  std::int64_t positions_;
};

}  // namespace piae::twin
