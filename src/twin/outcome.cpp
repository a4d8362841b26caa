#include "twin/outcome.hpp"

#include "twin/ranges.hpp"

namespace piae::twin {

namespace {

const std::string attribute = "open_contacts";

WeightedLoss last_of(const std::vector<double>& losses, const std::vector<double>& weights) {
  return {.loss = losses.back(), .weight = weights.back()};
}

/// Returns the three losses of curves with at least one epoch.
Outcome ends_of(const Curves& curves) {
  return {.differential = last_of(curves.differential, curves.alpha),
          .twin = last_of(curves.twin, curves.beta),
          .reconstruction = last_of(curves.reconstruction, curves.gamma),
          .states = {}};
}

}  // namespace

void write_outcome(artefact::Writer& writer, const Curves& curves, std::int64_t open_contacts) {
  writer.attribute(space_group, attribute, open_contacts);
  const Outcome ends = ends_of(curves);
  writer.attribute("/curves", "alpha_stationary", ends.differential.stationary());
  writer.attribute("/curves", "beta_stationary", ends.twin.stationary());
  writer.attribute("/curves", "gamma_stationary", ends.reconstruction.stationary());
}

bool has_outcome(const artefact::Reader& model) {
  return model.has(space_group) && model.has_attribute(space_group, attribute);
}

Outcome read_outcome(const artefact::Reader& model) {
  Curves curves;
  curves.read(model);
  if (curves.total.empty()) model.refuse("/curves", "has no epoch");
  Outcome outcome = ends_of(curves);
  outcome.states = read_points(model, space_group + "/points");
  outcome.open_contacts = model.integer(space_group, attribute, ranges::open_contacts);
  return outcome;
}

}  // namespace piae::twin
