#pragma once

#include <memory>

#include "base/random.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Training of PIAE-DT on the known windows C (paper 3.3.3). Epochs alternate between Stage 1,
/// where each network follows its own loss (eq. 24), and Stage 2, where all parameters and the
/// weights of the losses follow the total (eq. 25).
class TwinTraining : public nets::Trainee {
 public:
  /// The model: final and best networks, the digital twin space of those that generate, optimiser
  /// state, curves, and what generation needs to know. The last call on a training.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// `device` is "cpu" or "cuda". Throws Error(bad_input) when a class of C is silent.
std::unique_ptr<TwinTraining> make_twin_training(const signal::WindowSet& known,
                                                 const TwinOptions& options, const Stream& stream,
                                                 const std::string& device);

}  // namespace piae::twin
