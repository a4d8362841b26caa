#include "augment/healthy_plus_impulses.hpp"

#include "augment/healthy_model.hpp"

namespace piae::augment {

void HealthyPlusImpulses::train(const signal::WindowSet& known, const Stream& /*stream*/,
                                const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                                artefact::Writer& model) {
  zero::table_of(options_).require_order();
  const signal::WindowSet& healthy = require_healthy(healthy_, known);
  (void)zero::Machine(healthy);  // throws if the windows do not allow a model
  signal::write(model, healthy);
  zero::table_of(options_).write(model);
}

signal::WindowSet HealthyPlusImpulses::generate(const artefact::Reader& model, std::size_t count,
                                                const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet healthy = read_learned(model, signal::Role::healthy);
  const zero::Machine machine(healthy);
  zero::table_of(options_).read(model);
  return zero::make_windows(machine, count, stream,
                            [&](const zero::Scene& scene, const Stream& random) {
                              return zero::add_impulses(machine, options_, scene, random);
                            });
}

}  // namespace piae::augment
