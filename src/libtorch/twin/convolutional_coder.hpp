#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/options.hpp"

namespace piae::libtorch {

/// Encoder and decoder of Model 4. The paper (4.5.4) says no more than "convolutional"; the sizes
/// are our choice. Each has `depth` layers, of which all but one are convolutions along time, with
/// ReLU between them. Each convolution of the encoder keeps one of `stride` samples and doubles the
/// channels, and a dense layer makes (k~, c~) of what the last one gives. The decoder is its mirror
/// image, with transposed convolutions.
class ConvolutionalCoder final : public Coder {
 public:
  static constexpr std::int64_t channels = 16;  ///< after the first convolution
  static constexpr std::int64_t kernel = 8;     ///< samples
  static constexpr std::int64_t stride = 4;     ///< samples
  /// (kernel - stride) / 2, with which a convolution divides a length by the stride exactly.
  static constexpr std::int64_t padding = 2;

  /// Throws Error(usage) for fewer than two layers, and for a window whose length is no multiple of
  /// stride^(depth - 1) samples.
  ConvolutionalCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// The number of channels after i convolutions.
  [[nodiscard]] static std::int64_t channels_after(std::int64_t i) {
    return i == 0 ? 1 : channels << (i - 1);
  }

  twin::NetworkShape shape_;
  std::int64_t convolutions_;
  std::int64_t inner_length_ = 0;  ///< samples between the last convolution and the dense layer
};

}  // namespace piae::libtorch
