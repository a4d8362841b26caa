#include "zero/machine.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "bearing/strikes.hpp"
#include "signal/ranges.hpp"
#include "transfer/cepstrum.hpp"
#include "transfer/healthy.hpp"

namespace piae::zero {

namespace {

constexpr double least_samples = 2;  // between strikes
/// In samples: what changes faster along the spectrum are lines of the shaft and of gears, which no
/// blow excites.
constexpr double colour_quefrency = 256;

std::vector<std::size_t> windows_in(const signal::WindowSet& healthy, std::int32_t condition) {
  std::vector<std::size_t> windows;
  for (std::size_t i = 0; i < healthy.size(); ++i) {
    const bool in_every =
        healthy.condition.empty() || healthy.condition[i] == signal::every_condition;
    if (in_every || healthy.condition[i] == condition) windows.push_back(i);
  }
  return windows;
}

std::string called(const signal::WindowSet& healthy, std::int32_t condition) {
  if (condition == signal::every_condition) return "no healthy window";
  return "no healthy window of the tested condition '" +
         healthy.info.conditions[static_cast<std::size_t>(condition)].name + "'";
}

void require_rhythm(const signal::DatasetInfo& info, Label label, double rpm) {
  const double strike_hz =
      bearing::strike_frequency_hz(info.bearing, info.class_of(label).defect, rpm);
  if (strike_hz * least_samples <= info.sample_rate_hz) return;
  throw Error(
      Exit::bad_input,
      fmt::format("class {} is struck {:g} times a second at {:g} rpm, which windows at {:g} Hz do "
                  "not show: they need a higher sampling rate",
                  info.class_of(label).name, strike_hz, rpm, info.sample_rate_hz));
}

void require_speed(const signal::WindowSet& healthy, std::size_t i) {
  const double rpm = healthy.speed_rpm(i);
  if (!signal::ranges::shaft_speed_rpm.holds(rpm)) {
    throw Error(Exit::bad_input,
                fmt::format("healthy window {} says a shaft speed of {:g} rpm, by which no defect "
                            "has a rhythm; describe the speed of its recording",
                            i, rpm));
  }
  for (const Label label : healthy.info.fault_labels()) require_rhythm(healthy.info, label, rpm);
}

}  // namespace

Machine::Machine(const signal::WindowSet& healthy) : healthy_(healthy) {
  bearing::validate(healthy.info.bearing);
  const std::vector<transfer::HealthySpectrum> spectra = transfer::healthy_spectra(healthy);
  for (const std::int32_t condition : healthy.info.tested_conditions()) {
    std::vector<std::size_t> windows = windows_in(healthy, condition);
    if (windows.empty()) {
      throw Error(Exit::bad_input, called(healthy, condition) +
                                       ": what no fault is known of is made from those of B");
    }
    for (const std::size_t i : windows) require_speed(healthy, i);
    heard_.push_back(
        {.condition = condition,
         .windows = std::move(windows),
         .log_amplitude = transfer::liftered(
             transfer::find_spectrum(spectra, condition)->log_amplitude, colour_quefrency)});
  }
}

Scene Machine::draw_scene(Label label, std::size_t index, Stream& random) const {
  const Heard& heard = heard_[index % heard_.size()];
  const std::size_t window = heard.windows[random.below(heard.windows.size())];
  const bearing::Defect defect = info().class_of(label).defect;
  const double rpm = healthy_.speed_rpm(window);
  return {.defect = defect,
          .condition = heard.condition,
          .shaft_speed_rpm = rpm,
          .strike_hz = bearing::strike_frequency_hz(info().bearing, defect, rpm),
          .healthy = healthy_.window(window)};
}

const Eigen::ArrayXd& Machine::log_amplitude(std::int32_t condition) const {
  return std::ranges::find(heard_, condition, &Heard::condition)->log_amplitude;
}

}  // namespace piae::zero
