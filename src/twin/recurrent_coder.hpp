#pragma once

#include "twin/sequence_coder.hpp"

namespace piae::twin {

/// Encoder and decoder of Model 5. The paper (4.5.4) says no more than "recurrent"; this is our
/// choice. Each has `depth` layers, of which all but one are gated recurrent units (Cho et al.
/// 2014). A window is read as a sequence of frames of 32 samples, of which 1024 samples have 32;
/// this is 32 times cheaper than sample by sample. The encoder reads the frames, and a dense layer
/// makes (k~, c~) of its last state. The decoder is given (k~, c~, label) at each frame, and a
/// dense layer makes the frame of its state.
class RecurrentCoder final : public SequenceCoder<RecurrentCoder> {
 public:
  static constexpr std::int64_t frame = 32;  ///< samples
  static constexpr std::int64_t units = 96;  ///< in a recurrent layer

  /// Throws Error(usage) for fewer than two layers, and for a window that is not a whole number of
  /// frames.
  RecurrentCoder(const NetworkShape& shape, const TwinOptions& options);

  [[nodiscard]] std::int64_t layers() const { return layers_; }  ///< that are recurrent
  [[nodiscard]] std::int64_t frames() const { return frames_; }

  [[nodiscard]] std::vector<nets::ParameterSpec> specs() const override;
  template <class T>
  [[nodiscard]] Layers<T> encoder_layers(nets::GradientArray<T>& parameters) const;
  template <class T>
  [[nodiscard]] Layers<T> decoder_layers(nets::GradientArray<T>& parameters) const;

 private:
  /// The recurrent layers, of which the first is given `input_length` inputs: one for each frame,
  /// or one for all.
  template <class T>
  [[nodiscard]] Layers<T> gru_layers(nets::GradientArray<T>& parameters,
                                     std::int64_t input_length) const;

  NetworkShape shape_;
  std::int64_t layers_;
  std::int64_t frames_;
};

}  // namespace piae::twin
