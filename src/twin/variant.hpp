#pragma once

namespace piae::twin {

/// The kind of layers that encoder and decoder are made of.
enum class CoderKind { dense, convolutional, recurrent, temporal, transformer };

/// What a variant of PIAE-DT is made of. An ablation (paper 4.5.4) differs from PIAE-DT in one of
/// these parts; everything else, settings included, is the same.
struct TwinVariant {
  CoderKind coder = CoderKind::dense;
  /// Whether there is the physics-informed module. Without it there is neither L_DDL nor L_DT, and
  /// encoder and decoder follow L_Rec (eq. 20) alone. What they then call k~ and c~, and store as
  /// such, are two positive numbers without a physical meaning.
  bool physics = true;
  /// Whether there is the encoder. Without it the (k~, c~) of the known windows must be given,
  /// since something else inferred them (phase/).
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
