#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of `piae-dt-tcn`: a temporal convolutional network (Bai, Kolter and Koltun
/// 2018), which the paper's outlook names. Each network has `depth` layers: one dense layer, and
/// residual blocks of two dilated convolutions along time as in Bai et al.: o = ReLU(x + F(x)), F =
/// convolution, ReLU, convolution, ReLU. Our choices, and why:
///
/// - A position is a frame of 16 samples, which a dense layer converts to the channels and back.
/// One position per sample would cost 16 times as much.
/// - The dilation grows by 4 from block to block (Bai et al. double it), because there are few
/// blocks. With two blocks a position sees 21 positions, 336 samples, in which each fault of cwru
/// causes at least two impacts (the outer race is slowest: one in 112 samples).
/// - Convolutions look to both sides. Those of Bai et al. are causal, because they predict the
/// future; a coder gets its window whole.
/// - The encoder averages over the positions, and a dense layer computes (k~, c~) from the mean:
/// these hold for the whole window, at every start angle. In the decoder a dense layer computes all
/// positions from (k~, c~, label), as in `piae-dt-cnn`, since a convolution cannot distinguish
/// them.
/// - No dropout, which would make (k~, c~) random, and no weight normalisation, which is for many
/// blocks. Blocks do not need a convolution of 1 tap in parallel, because all have the same
/// channels.
///
/// At 1024 samples, 10 classes and depth 3, encoder and decoder have 52 594 parameters (39 235 in
/// `piae-dt-cnn`, 184 162 in `piae-dt-rnn`) and 1.7e6 multiplications per window (0.6e6 in
/// `piae-dt-cnn`; 1.1e6 in the module).
class TemporalCoder final : public SequenceCoder<TemporalCoder> {
 public:
  static constexpr std::int64_t frame = 16;     ///< samples of a position
  static constexpr std::int64_t channels = 32;  ///< numbers of a position
  static constexpr std::int64_t kernel = 3;     ///< taps of a convolution
  static constexpr std::int64_t growth = 4;     ///< growth of the dilation from block to block

  /// Throws Error(usage) if there are fewer than two layers or more than ten, or if the window is
  /// not a whole number of frames.
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
