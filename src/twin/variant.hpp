#pragma once

namespace piae::twin {

/// What encoder and decoder are made of.
enum class CoderKind { dense, convolutional, recurrent };

/// The one part in which an ablation differs from PIAE-DT (paper 4.5.4); everything else, settings
/// included, is the same.
struct TwinVariant {
  CoderKind coder = CoderKind::dense;
  /// Without the physics-informed module there is neither L_DDL nor L_DT, and encoder and decoder
  /// follow L_Rec (eq. 20) alone. What they then call k~ and c~, and store as such, is a pair of
  /// positive numbers without a physical meaning.
  bool physics = true;
  /// Without the encoder, (k~, c~) of the known windows are given: they were inferred otherwise
  /// (phase/).
  bool encoder = true;
};

inline constexpr TwinVariant full_model{};                                            // Model 1
inline constexpr TwinVariant without_physics{.physics = false};                       // Model 2
inline constexpr TwinVariant convolutional_model{.coder = CoderKind::convolutional};  // Model 4
inline constexpr TwinVariant recurrent_model{.coder = CoderKind::recurrent};          // Model 5
inline constexpr TwinVariant without_encoder{.physics = false, .encoder = false};     // phase/

}  // namespace piae::twin
