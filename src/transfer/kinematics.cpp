#include "transfer/kinematics.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "bearing/strikes.hpp"

namespace piae::transfer {

namespace {

constexpr double least_samples = 2;

const signal::ClassInfo& class_of(const signal::WindowSet& known, std::size_t i) {
  return known.info.class_of(known.labels[i]);
}

void require_rhythm_at(const signal::WindowSet& known, std::size_t i, double rpm) {
  const double rate_hz = known.info.sample_rate_hz;
  if (period_s(known, i, rpm) * rate_hz >= least_samples) return;
  throw Error(
      Exit::bad_input,
      fmt::format("class {} is struck {:g} times a second at {:g} rpm, which windows at {:g} "
                  "Hz do not show: they need a higher sampling rate",
                  class_of(known, i).name, 1 / period_s(known, i, rpm), rpm, rate_hz));
}

}  // namespace

double period_s(const signal::WindowSet& known, std::size_t i, double rpm) {
  return 1 / bearing::strike_frequency_hz(known.info.bearing, class_of(known, i).defect, rpm);
}

double passage_s(const signal::WindowSet& known, std::size_t i, double size_mm, double rpm) {
  return bearing::passage_s(known.info.bearing,
                            {.kind = class_of(known, i).defect, .size_mm = size_mm}, rpm);
}

void require_rhythm(const signal::WindowSet& known) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    require_rhythm_at(known, i, known.speed_rpm(i));
    if (known.info.conditions.empty()) continue;
    for (const std::int32_t tested : known.info.tested_conditions()) {
      require_rhythm_at(known, i, known.info.speed_rpm(tested));
    }
  }
}

}  // namespace piae::transfer
