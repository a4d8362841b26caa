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

void arrive(const signal::WindowSet& known, std::size_t count, signal::WindowSet& made) {
  if (known.info.conditions.empty()) return;
  for (const Label label : known.info.fault_labels()) {
    for (std::size_t i = 0; i < count; ++i) {
      const Journey journey = journey_of(known, label, i);
      made.condition.push_back(journey.condition);
      made.shaft_speed_rpm.push_back(journey.to_rpm);
    }
  }
}

}  // namespace piae::transfer
