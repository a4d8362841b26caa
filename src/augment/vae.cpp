#include "augment/vae.hpp"

#include "augment/latent_training.hpp"

namespace piae::augment {

void Vae::bind(const cli::Options& command) { augment::bind(command, options_); }

void Vae::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  LatentTraining training(known, options_, {"squared_error", "kl"}, stream,
                          [&](const LatentTask& task, const Stream& initial) {
                            return train_.chosen(compute)(task, initial, compute.device);
                          });
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet Vae::generate(const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute) {
  return augment::generate(model, count, stream, open_.chosen(compute), compute.device);
}

}  // namespace piae::augment
