#pragma once

#include "libtorch/twin/coder.hpp"
#include "twin/options.hpp"

namespace piae::libtorch {

/// Encoder and decoder of Model 5. The paper (4.5.4) says no more than "recurrent"; this is our
/// choice. Each has `depth` layers, of which all but one are gated recurrent units (Cho et al.
/// 2014). A window is read as a sequence of frames of 32 samples, of which 1024 samples have 32;
/// this is 32 times cheaper than sample by sample. The encoder reads the frames, and a dense layer
/// makes (k~, c~) of its last state. The decoder is given (k~, c~, label) at each frame, and a
/// dense layer makes the frame of its state.
class RecurrentCoder final : public Coder {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples
  static constexpr std::int64_t units = 96;  ///< in a recurrent layer

  /// Throws Error(usage) for fewer than two layers, and for a window that is not a whole number of
  /// frames.
  RecurrentCoder(const twin::NetworkShape& shape, const twin::TwinOptions& options);

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] torch::Tensor encode(const ParameterSet& parameters,
                                     const torch::Tensor& x) const override;
  [[nodiscard]] torch::Tensor decode(const ParameterSet& parameters,
                                     const torch::Tensor& input) const override;

 private:
  /// The states of the last recurrent layer: [batch, frames, inputs] -> [batch, frames, units].
  [[nodiscard]] torch::Tensor run_gru(const ParameterSet& parameters, const std::string& name,
                                      const torch::Tensor& x) const;

  twin::NetworkShape shape_;
  std::int64_t layers_;  ///< number of recurrent layers
};

}  // namespace piae::libtorch
