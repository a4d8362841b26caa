#include "augment/back_ends.hpp"

#include "latent/generator.hpp"
#include "seam/libtorch.hpp"
#include "twin/one_core_backend.hpp"

namespace piae::augment {

twin::Engine twin_engine(const Compute& compute) {
  const Backends<twin::MakeEngine> engines{.native = twin::one_core_engine,
                                           .libtorch = seam::back_end(&seam::BackEnds::twin)};
  return engines.chosen(compute)(compute.device);
}

signal::WindowSet generate_from_latent(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& compute) {
  const Backends<latent::OpenGenerator> generators{
      .native = latent::open_generator, .libtorch = seam::back_end(&seam::BackEnds::generator)};
  return latent::generate(model, count, stream, generators.chosen(compute), compute.device);
}

}  // namespace piae::augment
