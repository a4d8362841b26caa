#include "augment/vae.hpp"

#include "libtorch/back_ends.hpp"
#include "latent/training.hpp"

namespace piae::augment {

namespace {

Backends<latent::MakeVae> trainings() {
  return {latent::vae, libtorch::back_end(&libtorch::BackEnds::vae)};
}

Backends<latent::OpenGenerator> generators() {
  return {latent::open_generator, libtorch::back_end(&libtorch::BackEnds::generator)};
}

}  // namespace

bool Vae::needs_libtorch(const Compute& compute) const {
  return trainings().needs_libtorch(compute);
}

void Vae::bind(const cli::Options& command) { latent::bind(command, options_); }

void Vae::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  latent::LatentTraining training(known, options_, {"squared_error", "kl"}, stream,
                          [&](const latent::LatentTask& task, const Stream& initial) {
                            return trainings().chosen(compute)(task, initial, compute.device);
                          });
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet Vae::generate(const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute) {
  return latent::generate(model, count, stream, generators().chosen(compute), compute.device);
}

}  // namespace piae::augment
