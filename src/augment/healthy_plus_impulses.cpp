#include "augment/healthy_plus_impulses.hpp"

#include "augment/healthy_model.hpp"

namespace piae::augment {

void HealthyPlusImpulses::train(const signal::WindowSet& known, const Stream& /*stream*/,
                                const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                                artefact::Writer& model) {
  zero::require_order(options_);
  const signal::WindowSet& healthy = require_heard(healthy_, known);
  (void)zero::Machine(healthy);  // refuses what cannot be
  signal::write(model, healthy);
  zero::write(model, options_);
}

signal::WindowSet HealthyPlusImpulses::generate(const artefact::Reader& model, std::size_t count,
                                                const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet healthy = read_learned(model, signal::Role::healthy);
  const zero::Machine machine(healthy);
  const zero::ImpulseOptions options = zero::read_impulse_options(model);
  return zero::make_windows(machine, count, stream,
                            [&](const zero::Scene& scene, const Stream& random) {
                              return zero::add_impulses(machine, options, scene, random);
                            });
}

}  // namespace piae::augment
