#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// The training of PIAE-DT, or of one of its variants, on the known windows C (paper 3.3.3). Epochs
/// alternate between Stage 1, where each network follows its own loss (eq. 24), and Stage 2, where
/// all parameters and the loss weights follow the total loss (eq. 25). Without the physics module
/// every loss is L_Rec. run_epoch() throws Error(failed) if a loss is not finite.
class TwinTraining : public nets::Trainee {
 public:
  /// Writes the model: the networks after the last and after the best epoch, the digital twin space
  /// of those that generate, the state of Adam, the curves, and the model's description. Must be
  /// the last call, because it may replace the last parameters by the best ones.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// `states` must be given if the variant has no encoder. Throws Error(bad_input) if a class of C is
/// silent, and Error(usage) if the variant does not support the window length or the depth.
std::unique_ptr<TwinTraining> make_twin_training(const signal::WindowSet& known,
                                                 const TwinOptions& options,
                                                 const TwinVariant& variant, const Stream& stream,
                                                 const Engine& engine,
                                                 const std::optional<KnownStates>& states = {});

}  // namespace piae::twin
