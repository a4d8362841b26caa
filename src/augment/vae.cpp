#include "augment/vae.hpp"

#include <utility>

#include "augment/back_ends.hpp"
#include "latent/training.hpp"
#include "seam/libtorch.hpp"

namespace piae::augment {

namespace {

Backends<latent::MakeVae> vae_trainings() {
  return {.native = latent::vae, .libtorch = seam::back_end(&seam::BackEnds::vae)};
}

}  // namespace

bool Vae::needs_libtorch(const Compute& compute) const { return piae::needs_libtorch(compute); }

void Vae::bind(const cli::Options& command) { latent::bind(command, options_); }

void Vae::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  const auto make_backend = [&](latent::LatentTask task, const Stream& initial) {
    return vae_trainings().chosen(compute)(std::move(task), initial, compute.device);
  };
  latent::LatentTraining training(known, options_, {"squared_error", "kl"}, stream, make_backend);
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet Vae::generate(const artefact::Reader& model, std::size_t count,
                                const Stream& stream, const Compute& compute) {
  return generate_from_latent(model, count, stream, compute);
}

}  // namespace piae::augment
