#include "transfer/known_bearings.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "bearing/impact_frequency.hpp"
#include "impacts/times.hpp"

namespace piae::transfer {

namespace {

const signal::ClassInfo& class_of(const signal::WindowSet& known, std::size_t i) {
  return known.info.class_of(known.labels[i]);
}

}  // namespace

std::vector<KnownBearing> bearings_of(const signal::WindowSet& known) {
  std::map<std::tuple<Label, std::int32_t, double>, KnownBearing> bearings_by_key;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::int32_t condition =
        known.condition.empty() ? signal::every_condition : known.condition[i];
    KnownBearing& bearing = bearings_by_key[{known.labels[i], condition, known.size_mm(i)}];
    bearing.label = known.labels[i];
    bearing.size_mm = known.size_mm(i);
    bearing.speed_rpm += known.speed_rpm(i);
    bearing.windows.push_back(i);
  }
  std::vector<KnownBearing> bearings;
  for (auto& [key, bearing] : bearings_by_key) {
    bearing.speed_rpm /= static_cast<double>(bearing.windows.size());
    bearings.push_back(std::move(bearing));
  }
  return bearings;
}

bool tests_other_bearings(const signal::WindowSet& known) {
  return !known.defect_size_mm.empty() &&
         std::ranges::any_of(known.info.conditions, [](const auto& condition) {
           return condition.test && !condition.known;
         });
}

double period_s(const signal::WindowSet& known, std::size_t i, double rpm) {
  return 1 / bearing::impact_frequency_hz(known.info.bearing, class_of(known, i).defect, rpm);
}

double passage_s(const signal::WindowSet& known, std::size_t i, double size_mm, double rpm) {
  return bearing::passage_s(known.info.bearing,
                            {.fault_type = class_of(known, i).defect, .size_mm = size_mm}, rpm);
}

void require_rate(const signal::WindowSet& known) {
  const signal::DatasetInfo& info = known.info;
  for (std::size_t i = 0; i < known.size(); ++i) {
    impacts::require_rate(info, known.labels[i], known.speed_rpm(i));
    if (info.conditions.empty()) continue;
    for (const std::int32_t tested : info.tested_conditions()) {
      impacts::require_rate(info, known.labels[i], info.speed_rpm(tested));
    }
  }
}

}  // namespace piae::transfer
