#pragma once

#include <string>

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// The names of the layers of an encoder or a decoder: <network>/conv0, <network>/conv1, ..., and
/// <network>/dense.
std::string convolution_name(const std::string& network, std::int64_t i);
std::string dense_name(const std::string& network);

/// Encoder and decoder of Model 4. The paper (4.5.4) says no more than "convolutional"; the sizes
/// are our choice. Each has `depth` layers, of which all but one are convolutions along time, with
/// ReLU between them. Each convolution of the encoder keeps one of `stride` samples and doubles the
/// channels, and a dense layer makes (k~, c~) of what the last one gives. The decoder is its mirror
/// image, with transposed convolutions.
class ConvolutionalCoder final : public SequenceCoder<ConvolutionalCoder> {
 public:
  static constexpr std::int64_t channels = 16;  ///< after the first convolution
  static constexpr std::int64_t kernel = 8;     ///< samples
  static constexpr std::int64_t stride = 4;     ///< samples
  /// (kernel - stride) / 2, with which a convolution divides a length by the stride exactly.
  static constexpr std::int64_t padding = 2;

  /// Throws Error(usage) for fewer than two layers, and for a window whose length is no multiple of
  /// stride^(depth - 1) samples.
  ConvolutionalCoder(const NetworkShape& shape, const TwinOptions& options);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

  /// Of the encoder, and as many of the decoder.
  [[nodiscard]] std::int64_t convolutions() const { return convolutions_; }
  /// What the encoder's last convolution gives: channels, and samples of each.
  [[nodiscard]] std::int64_t inner_channels() const { return channels_after(convolutions_); }
  [[nodiscard]] std::int64_t inner_length() const { return inner_length_; }

 private:
  /// The number of channels after i convolutions.
  [[nodiscard]] static std::int64_t channels_after(std::int64_t i) {
    return i == 0 ? 1 : channels << (i - 1);
  }

  NetworkShape shape_;
  std::int64_t convolutions_;
  std::int64_t inner_length_ = 0;
};

}  // namespace piae::twin
