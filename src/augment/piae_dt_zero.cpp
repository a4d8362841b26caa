#include "augment/piae_dt_zero.hpp"

#include "augment/healthy_model.hpp"
#include "zero/twin.hpp"

namespace piae::augment {

void PiaeDtZero::train(const signal::WindowSet& known, const Stream& /*stream*/,
                       const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                       artefact::Writer& model) {
  zero::table_of(prior_).require_order();
  const signal::WindowSet& healthy = require_healthy(healthy_, known);
  (void)zero::Twin(zero::Machine(healthy), prior_);  // throws if the windows do not allow a model
  signal::write(model, healthy);
  zero::table_of(prior_).write(model);
}

signal::WindowSet PiaeDtZero::generate(const artefact::Reader& model, std::size_t count,
                                       const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSet healthy = read_learned(model, signal::Role::healthy);
  const zero::Machine machine(healthy);
  zero::table_of(prior_).read(model);
  const zero::Twin twin(machine, prior_);
  return zero::make_windows(
      machine, count, stream,
      [&](const zero::Scene& scene, const Stream& random) { return twin.make(scene, random); });
}

}  // namespace piae::augment
