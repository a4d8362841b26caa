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

/// The training of piae-dt-phase. First the inference of (k~, c~) is trained. Then PIAE-DT's
/// decoder is trained by L_Rec alone (twin/training.hpp), on the (k~, c~) that are inferred of the
/// known windows, and on these windows turned to one common angle.
class PhaseTraining : public nets::Trainee {
 public:
  /// Writes the model: inference, decoder, twin space, and where each known window starts on its
  /// fault cycle (/phase/start, in samples). This must be the last call.
  virtual void write_model(artefact::Writer& writer) = 0;
};

/// Throws Error(bad_input) when a class of C is silent or its windows are too short for its fault
/// cycle, and Error(usage) for options that leave the inference nothing to look for.
std::unique_ptr<PhaseTraining> make_phase_training(const signal::WindowSet& known,
                                                   const PhaseOptions& options,
                                                   const Stream& stream,
                                                   const twin::Engine& engine);

}  // namespace piae::phase
