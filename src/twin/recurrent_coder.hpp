#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of Model 5. The paper (4.5.4) only writes "recurrent"; this is our choice.
/// Each network has `depth` layers: one dense layer, and gated recurrent units (Cho et al. 2014). A
/// window is a sequence of frames of 32 samples (1024 samples have 32 frames), which is 32 times
/// cheaper than sample by sample. In the encoder, a dense layer computes (k~, c~) from the last
/// state. The decoder gets (k~, c~, label) at each frame, and a dense layer computes the frame from
/// the state.
class RecurrentCoder final : public SequenceCoder<RecurrentCoder> {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples
  static constexpr std::int64_t units = 96;  ///< units of a recurrent layer

  /// Throws Error(usage) if there are fewer than two layers, or if the window is not a whole number
  /// of frames.
  RecurrentCoder(const NetworkShape& shape, const TwinOptions& options);

  [[nodiscard]] std::int64_t layers() const { return layers_; }  ///< number of recurrent layers
  [[nodiscard]] std::int64_t frames() const { return frames_; }

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

 private:
  /// Returns the recurrent layers. The first has `input_length` inputs: one for each frame, or one
  /// for all.
  template <class T>
  [[nodiscard]] Layers<T> gru_layers(nets::GradientArray<T>& parameters,
                                     std::int64_t input_length) const;

  NetworkShape shape_;
  std::int64_t layers_;
  std::int64_t frames_;
};

}  // namespace piae::twin
