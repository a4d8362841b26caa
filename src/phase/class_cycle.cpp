#include "phase/class_cycle.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "bearing/impact_frequency.hpp"

namespace piae::phase {

double impact_frequency_hz(const signal::DatasetInfo& info, Label label) {
  const signal::ClassInfo& c = info.classes.at(index_of(label));
  if (c.defect == signal::Defect::none) {
    throw Error(Exit::bad_input,
                info.name + ": class " + c.name +
                    " does not have a defect, so it does not have a fault frequency");
  }
  return bearing::impact_frequency_hz(info.bearing, c.defect, info.known_speed_rpm());
}

signal::Cycle cycle_of_class(const signal::DatasetInfo& info, Label label, std::size_t length) {
  const double period = info.sample_rate_hz / impact_frequency_hz(info, label);
  const std::optional<signal::Cycle> cycle = signal::cycle_of(period, length);
  if (!cycle) {
    throw Error(
        Exit::bad_input,
        fmt::format("{}: windows of {} samples are too short for one impact of class {} every "
                    "{:.1f} samples; use longer windows (split --window)",
                    info.name, length, info.classes.at(index_of(label)).name, period));
  }
  return *cycle;
}

}  // namespace piae::phase
