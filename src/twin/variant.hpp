#pragma once

namespace piae::twin {

/// Layer type of encoder and decoder.
enum class CoderKind { dense, convolutional, recurrent, temporal, transformer };

/// Parts of a variant of PIAE-DT. An ablation (paper 4.5.4) differs from PIAE-DT in one of these
/// parts; everything else, including settings, is the same.
struct TwinVariant {
  CoderKind coder = CoderKind::dense;
  /// True with the physics-informed module. Without it there is neither L_DDL nor L_DT, and encoder
  /// and decoder follow only L_Rec (eq. 20). The stored k~ and c~ are then two positive numbers
  /// without physical meaning.
  bool physics = true;
  /// True with the encoder. Without it the (k~, c~) of the known windows must be given, because
  /// they are inferred elsewhere (phase/).
  bool encoder = true;
};

inline constexpr TwinVariant full_model{};                                            // Model 1
inline constexpr TwinVariant without_physics{.physics = false};                       // Model 2
inline constexpr TwinVariant convolutional_model{.coder = CoderKind::convolutional};  // Model 4
inline constexpr TwinVariant recurrent_model{.coder = CoderKind::recurrent};          // Model 5
inline constexpr TwinVariant temporal_model{.coder = CoderKind::temporal};            // outlook
inline constexpr TwinVariant transformer_model{.coder = CoderKind::transformer};      // outlook
inline constexpr TwinVariant without_encoder{.physics = false, .encoder = false};     // phase/

}  // namespace piae::twin
