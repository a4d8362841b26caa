#include "augment/wgan_gp.hpp"

#include <utility>

#include "augment/back_ends.hpp"
#include "latent/training.hpp"
#include "seam/libtorch.hpp"

namespace piae::augment {

namespace {

Backends<latent::MakeWganGp> wgan_gp_trainings() {
  return {.native = latent::wgan_gp, .libtorch = seam::back_end(&seam::BackEnds::wgan_gp)};
}

}  // namespace

bool WganGp::needs_libtorch(const Compute& compute) const { return piae::needs_libtorch(compute); }

void WganGp::bind(const cli::Options& command) { latent::bind(command, options_); }

void WganGp::train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
                   const nets::Checkpoint& checkpoint, artefact::Writer& model) {
  const auto make_backend = [&](latent::LatentTask task, const Stream& initial) {
    return wgan_gp_trainings().chosen(compute)(std::move(task), options_, initial, compute.device);
  };
  latent::LatentTraining training(known, options_.networks, {"wasserstein", "gradient_penalty"},
                                  stream, make_backend);
  nets::run_epochs(training, checkpoint);
  training.write_model(model);
}

signal::WindowSet WganGp::generate(const artefact::Reader& model, std::size_t count,
                                   const Stream& stream, const Compute& compute) {
  return generate_from_latent(model, count, stream, compute);
}

}  // namespace piae::augment
