#include "transfer/journey.hpp"

#include <vector>

namespace piae::transfer {

Journey journey_of(const signal::WindowSet& known, Label label, std::size_t index) {
  const std::vector<std::size_t> own = known.indices_of(label);
  Journey journey;
  journey.known = own[index % own.size()];
  journey.from_rpm = known.speed_rpm(journey.known);
  const std::vector<std::int32_t> tested = known.info.tested_conditions();
  journey.condition = tested[index / own.size() % tested.size()];
  journey.to_rpm =
      known.info.conditions.empty() ? journey.from_rpm : known.info.speed_rpm(journey.condition);
  return journey;
}

signal::MadeWindow arrived(const signal::WindowSet& known, const Journey& journey,
                           const std::vector<double>& samples) {
  signal::MadeWindow made(std::vector<float>(samples.begin(), samples.end()));
  made.parents = signal::parents_of({journey.known});
  if (known.info.conditions.empty()) return made;
  made.condition = journey.condition;
  made.shaft_speed_rpm = journey.to_rpm;
  return made;
}

}  // namespace piae::transfer
