#include "augment/piae_dt.hpp"

#include "twin/generation.hpp"
#include "twin/inference.hpp"
#include "twin/training.hpp"

namespace piae::augment {

void PiaeDt::bind(const cli::Options& command) { twin::bind(command, options_); }

void PiaeDt::train(const signal::WindowSet& known, const Stream& stream, const std::string& device,
                   const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  const auto training = twin::make_twin_training(known, options_, variant_, stream, device);
  nets::run_epochs(*training, checkpoint);
  training->write_model(model);
}

signal::WindowSet PiaeDt::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const std::string& device) {
  return twin::generate(model, variant_, count, stream, device);
}

std::vector<signal::DynamicParameters> PiaeDt::infer(const artefact::Reader& model,
                                                     const signal::WindowSet& windows,
                                                     const std::string& device) {
  return twin::infer(model, variant_, windows, device);
}

}  // namespace piae::augment
