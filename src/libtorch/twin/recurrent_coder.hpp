#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/options.hpp"

namespace piae::libtorch {

/// Encoder and decoder of Model 5 (paper 4.5.4, which says no more than "recurrent"): `depth`
/// layers each, of which all but one are gated recurrent units (Cho et al. 2014). A window is a
/// sequence of frames of 32 samples, 32 of them in 1024 samples: 32 times cheaper than sample by
/// sample (project's notes). The encoder reads the frames, and a dense layer makes (k~, c~) of its
/// last state; the decoder is given (k~, c~, label) at each frame, and a dense layer makes the
/// frame of its state.
class RecurrentCoder final : public Coder {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples
  static constexpr std::int64_t units = 96;  ///< of a recurrent layer; our choice

  /// Throws Error(usage) below two layers, and for a window that is no multiple of a frame.
  RecurrentCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// States of the last recurrent layer, [batch, frames, inputs] -> [batch, frames, units].
  [[nodiscard]] torch::Tensor run_gru(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x) const;

  twin::NetworkShape shape_;
  std::int64_t layers_;  ///< recurrent ones
};

}  // namespace piae::libtorch
