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

/// Training of PIAE-DT, or of one of its variants, on the known windows C (paper 3.3.3). Epochs
/// alternate between Stage 1, where each network follows its own loss (eq. 24), and Stage 2, where
/// all parameters and the weights of the losses follow the total (eq. 25). Without the physics
/// module every loss is L_Rec.
class TwinTraining : public nets::Trainee {
 public:
  /// The model: final and best networks, the digital twin space of those that generate, optimiser
  /// state, curves, and what generation needs to know. The last call on a training.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// `states` are given where the variant has no encoder. Throws
/// Error(bad_input) when a class of C is silent, and Error(usage) for windows or a depth that the
/// variant cannot have.
std::unique_ptr<TwinTraining> make_twin_training(const signal::WindowSet& known,
                                                 const TwinOptions& options,
                                                 const TwinVariant& variant, const Stream& stream,
                                                 const Engine& engine,
                                                 const std::optional<KnownStates>& states = {});

}  // namespace piae::twin
