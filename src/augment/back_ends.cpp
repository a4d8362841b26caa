#include "augment/back_ends.hpp"

#include "latent/generator.hpp"
#include "seam/libtorch.hpp"
#include "twin/one_core_backend.hpp"

namespace piae::augment {

Backends<twin::MakeEngine> twin_engines(const twin::TwinVariant& variant) {
  const bool is_libtorchs = variant.coder == twin::CoderKind::convolutional ||
                            variant.coder == twin::CoderKind::recurrent;
  return {.native = is_libtorchs ? nullptr : twin::one_core_engine,
          .libtorch = seam::back_end(&seam::BackEnds::twin)};
}

twin::Engine twin_engine(const twin::TwinVariant& variant, const Compute& compute) {
  return twin_engines(variant).chosen(compute)(compute.device);
}

signal::WindowSet generate_from_latent(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& compute) {
  const Backends<latent::OpenGenerator> generators{
      .native = latent::open_generator, .libtorch = seam::back_end(&seam::BackEnds::generator)};
  return latent::generate(model, count, stream, generators.chosen(compute), compute.device);
}

}  // namespace piae::augment
