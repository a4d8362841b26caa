#include "augment/piae_dt.hpp"

#include "augment/back_ends.hpp"
#include "twin/generation.hpp"
#include "twin/inference.hpp"
#include "twin/training.hpp"

namespace piae::augment {

bool PiaeDt::needs_libtorch(const Compute& compute) const { return piae::needs_libtorch(compute); }

void PiaeDt::bind(const cli::Options& command) {
  twin::bind(command, options_);
  twin::bind_space(command, options_);
}

void PiaeDt::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                   const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  const auto training =
      twin::make_twin_training(known, options_, variant_, stream, twin_engine(compute));
  nets::run_epochs(*training, checkpoint);
  training->write_model(model);
}

signal::WindowSet PiaeDt::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const Compute& compute) {
  return twin::generate(model, variant_, count, stream, twin_engine(compute));
}

std::vector<signal::DynamicParameters> PiaeDt::infer(const artefact::Reader& model,
                                                     const signal::WindowSet& windows,
                                                     const Compute& compute) {
  return twin::infer(model, variant_, windows, twin_engine(compute));
}

}  // namespace piae::augment
