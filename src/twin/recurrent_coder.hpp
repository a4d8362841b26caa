#pragma once

#include "nets/recurrent_specs.hpp"
#include "twin/coder.hpp"

namespace piae::twin {

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
  RecurrentCoder(const NetworkShape& shape, const TwinOptions& options);

  [[nodiscard]] std::int64_t layers() const { return size_.layers; }  ///< that are recurrent
  [[nodiscard]] std::int64_t frames() const { return shape_.samples / frame; }

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  [[nodiscard]] std::unique_ptr<Network> encoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override;
  [[nodiscard]] std::unique_ptr<Network> decoder(const std::shared_ptr<Parameters>& parameters,
                                                 std::int64_t most_rows) const override;

 private:
  NetworkShape shape_;
  nets::RecurrentSize size_;
};

}  // namespace piae::twin
