#pragma once

#include <memory>
#include <vector>

#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "nets/trainee.hpp"
#include "phase/options.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"

namespace piae::phase {

/// Training of piae-dt-phase: first the inference of (k~, c~), then, with what it infers of the
/// known windows, and with their start angles taken out, PIAE-DT's decoder by L_Rec alone
/// (twin/training.hpp).
class PhaseTraining : public nets::Trainee {
 public:
  /// The model: inference, decoder, and the twin space with the start of each known window on its
  /// fault cycle, /phase/start, in samples. The last call on a training.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// Throws Error(bad_input) when a class of C is silent or its windows are too short for its fault
/// cycle.
std::unique_ptr<PhaseTraining> make_phase_training(const signal::WindowSet& known,
                                                   const PhaseOptions& options,
                                                   const Stream& stream,
                                                   const twin::Engine& engine);

}  // namespace piae::phase
