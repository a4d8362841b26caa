#pragma once

#include <string>

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Return the names of the layers of an encoder or a decoder: <network>/conv0, <network>/conv1,
/// ..., and <network>/dense.
std::string convolution_name(const std::string& network, std::int64_t i);
std::string dense_name(const std::string& network);

/// Encoder and decoder of Model 4. The paper (4.5.4) only writes "convolutional"; the sizes are our
/// choice. Each network has `depth` layers: one dense layer, and convolutions along time with ReLU
/// between them. Each convolution of the encoder keeps one of `stride` samples and doubles the
/// channels. A dense layer computes (k~, c~) from the last one. The decoder is the mirror image,
/// with transposed convolutions.
class ConvolutionalCoder final : public SequenceCoder<ConvolutionalCoder> {
 public:
  static constexpr std::int64_t channels = 16;  ///< after the first convolution
  static constexpr std::int64_t kernel = 8;     ///< samples
  static constexpr std::int64_t stride = 4;     ///< samples
  /// (kernel - stride) / 2, which makes a convolution divide a length by the stride exactly.
  static constexpr std::int64_t padding = 2;

  /// Throws Error(usage) if there are fewer than two layers, or if the window length is not a
  /// multiple of stride^(depth - 1) samples.
  ConvolutionalCoder(const NetworkShape& shape, const TwinOptions& options);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

  /// Returns the number of convolutions of the encoder, which is also that of the decoder.
  [[nodiscard]] std::int64_t convolutions() const { return convolutions_; }
  /// Size of the output of the encoder's last convolution: channels, and samples per channel.
  [[nodiscard]] std::int64_t inner_channels() const { return channels_after(convolutions_); }
  [[nodiscard]] std::int64_t inner_length() const { return inner_length_; }

 private:
  /// Returns the number of channels after i convolutions.
  [[nodiscard]] static std::int64_t channels_after(std::int64_t i) {
    return i == 0 ? 1 : channels << (i - 1);
  }

  NetworkShape shape_;
  std::int64_t convolutions_;
  std::int64_t inner_length_ = 0;
};

}  // namespace piae::twin
