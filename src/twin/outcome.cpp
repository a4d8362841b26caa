#include "twin/outcome.hpp"

#include "twin/curves.hpp"

namespace piae::twin {

namespace {

const std::string group = "/twin_space";
const std::string attribute = "open_contacts";

WeightedLoss last_of(const artefact::Reader& model, const std::vector<double>& losses,
                     const std::vector<double>& weights) {
  if (losses.empty() || losses.size() != weights.size()) model.refuse("/curves", "has no epoch");
  return {.loss = losses.back(), .weight = weights.back()};
}

}  // namespace

void write_open_contacts(artefact::Writer& writer, std::int64_t count) {
  writer.attribute(group, attribute, count);
}

bool has_outcome(const artefact::Reader& model) {
  return model.has(group) && model.has_attribute(group, attribute);
}

Outcome read_outcome(const artefact::Reader& model) {
  Curves curves;
  curves.read(model);
  return {.differential = last_of(model, curves.differential, curves.alpha),
          .twin = last_of(model, curves.twin, curves.beta),
          .reconstruction = last_of(model, curves.reconstruction, curves.gamma),
          .states = read_points(model, group + "/points"),
          .open_contacts = model.integer(group, attribute)};
}

}  // namespace piae::twin
