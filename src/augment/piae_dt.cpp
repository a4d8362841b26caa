#include "augment/piae_dt.hpp"

#include "twin/generation.hpp"
#include "twin/inference.hpp"
#include "twin/training.hpp"

namespace piae::augment {

void PiaeDt::bind(const cli::Options& command) { twin::bind(command, options_); }

void PiaeDt::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                   const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  const auto training = twin::make_twin_training(known, options_, variant_, stream,
                                                 engines_.chosen(compute)(compute.device));
  nets::run_epochs(*training, checkpoint);
  training->write_model(model);
}

signal::WindowSet PiaeDt::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const Compute& compute) {
  return twin::generate(model, variant_, count, stream, engines_.chosen(compute)(compute.device));
}

std::vector<signal::DynamicParameters> PiaeDt::infer(const artefact::Reader& model,
                                                     const signal::WindowSet& windows,
                                                     const Compute& compute) {
  return twin::infer(model, variant_, windows, engines_.chosen(compute)(compute.device));
}

}  // namespace piae::augment
