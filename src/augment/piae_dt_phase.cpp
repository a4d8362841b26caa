#include "augment/piae_dt_phase.hpp"

#include "augment/back_ends.hpp"
#include "phase/generation.hpp"
#include "phase/stored_inference.hpp"
#include "phase/training.hpp"

namespace piae::augment {

bool PiaeDtPhase::needs_libtorch(const Compute& compute) const {
  return piae::needs_libtorch(compute);
}

void PiaeDtPhase::bind(const cli::Options& command) { phase::bind(command, options_); }

void PiaeDtPhase::train(const signal::WindowSet& known, const Stream& stream,
                        const Compute& compute, const nets::Checkpoint& checkpoint,
                        artefact::Writer& model) {
  const auto training = phase::make_phase_training(known, options_, stream, twin_engine(compute));
  nets::run_epochs(*training, checkpoint);
  training->write_model(model);
}

signal::WindowSet PiaeDtPhase::generate(const artefact::Reader& model, std::size_t count,
                                        const Stream& stream, const Compute& compute) {
  return phase::generate(model, count, stream, twin_engine(compute));
}

std::vector<signal::DynamicParameters> PiaeDtPhase::infer(const artefact::Reader& model,
                                                          const signal::WindowSet& windows,
                                                          const Compute& /*compute*/) {
  return phase::infer(model, windows);
}

}  // namespace piae::augment
