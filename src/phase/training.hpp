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

/// The training of piae-dt-phase. First trains the inference of (k~, c~). Then trains PIAE-DT's
/// decoder by L_Rec alone (twin/training.hpp), on the (k~, c~) inferred from the known windows and
/// on these windows, circularly shifted to one common angle.
class PhaseTraining : public nets::Trainee {
 public:
  /// Writes the model: inference, decoder, twin space, and the start of each known window on its
  /// fault cycle (/phase/start, in samples). Must be the last call.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// Throws Error(bad_input) if a class of C is silent or its windows are too short for its fault
/// cycle, and Error(usage) if the options leave the inference an empty range.
std::unique_ptr<PhaseTraining> make_phase_training(const signal::WindowSet& known,
                                                   const PhaseOptions& options,
                                                   const Stream& stream,
                                                   const twin::Engine& engine);

}  // namespace piae::phase
