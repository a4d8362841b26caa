#include "zero/machine.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bearing/impact_frequency.hpp"
#include "impacts/response.hpp"
#include "impacts/times.hpp"
#include "signal/ranges.hpp"

namespace piae::zero {

namespace {

/// Relative tolerance of the speeds of a machine under different loads.
constexpr double same_speed = 0.05;
/// Unit: samples. Faster changes along the spectrum are lines of the shaft and of gears, which
/// impacts do not excite.
constexpr double colour_quefrency = 256;

/// Returns the windows of a condition whose speed is nearest to the condition's.
std::vector<std::size_t> windows_near(const signal::WindowSet& healthy, std::int32_t condition) {
  std::vector<std::size_t> windows = impacts::windows_in(healthy, condition);
  if (windows.empty() || condition == signal::every_condition) return windows;
  const double rpm = healthy.info.speed_rpm(condition);
  const auto away = [&](std::size_t i) { return std::abs(healthy.speed_rpm(i) - rpm); };
  const double nearest = away(std::ranges::min(windows, {}, away));
  std::erase_if(windows, [&](std::size_t i) { return away(i) > nearest + same_speed * rpm; });
  return windows;
}

std::string called(const signal::WindowSet& healthy, std::int32_t condition) {
  if (condition == signal::every_condition) return "there are no healthy windows";
  return "there are no healthy windows of the tested condition '" +
         healthy.info.conditions[static_cast<std::size_t>(condition)].name + "'";
}

void require_impact_times(const signal::WindowSet& healthy, Label label, double rpm) {
  const signal::DatasetInfo& info = healthy.info;
  impacts::require_rate(info, label, rpm);
  const signal::ClassInfo& c = info.class_of(label);
  const double impact_frequency_hz = bearing::impact_frequency_hz(info.bearing, c.defect, rpm);
  const double samples = std::ceil(info.sample_rate_hz / impact_frequency_hz);
  if (static_cast<double>(healthy.length) >= samples) return;
  throw Error(
      Exit::bad_input,
      fmt::format("class {} has {:g} impacts per second at {:g} rpm, so windows of {} samples "
                  "may miss them; use {:.0f} samples or more (split --window)",
                  c.name, impact_frequency_hz, rpm, healthy.length, samples));
}

void require_speed(const signal::WindowSet& healthy, std::size_t i) {
  const double rpm = healthy.speed_rpm(i);
  if (!signal::ranges::shaft_speed_rpm.holds(rpm)) {
    throw Error(Exit::bad_input,
                fmt::format("healthy window {} has a shaft speed of {:g} rpm, which is impossible; "
                            "describe the speed of its recording (shaft_speed_rpm)",
                            i, rpm));
  }
  for (const Label label : healthy.info.fault_labels()) require_impact_times(healthy, label, rpm);
}

}  // namespace

Machine::Machine(const signal::WindowSet& healthy) : healthy_(healthy) {
  bearing::validate(healthy.info.bearing);
  for (std::size_t i = 0; i < healthy.size(); ++i) require_speed(healthy, i);
  for (const std::int32_t condition : healthy.info.tested_conditions()) {
    std::vector<std::size_t> windows = windows_near(healthy, condition);
    if (windows.empty()) {
      throw Error(Exit::bad_input,
                  called(healthy, condition) + "; give --healthy B.h5 with at least one");
    }
    healthy_conditions_.push_back({.condition = condition, .sound = sound_of(std::move(windows))});
  }
}

std::size_t Machine::sound_of(std::vector<std::size_t> windows) {
  const auto known = std::ranges::find(sounds_, windows, &Sound::windows);
  if (known != sounds_.end()) return static_cast<std::size_t>(known - sounds_.begin());
  const Eigen::ArrayXd seen = impacts::log_amplitude(healthy_, windows);
  sounds_.push_back({.windows = std::move(windows),
                     .log_amplitude = impacts::liftered(seen - seen.mean(), colour_quefrency)});
  return sounds_.size() - 1;
}

Scene Machine::draw_scene(Label label, std::size_t index, Stream& random) const {
  const HealthyCondition& of_condition = healthy_conditions_[index % healthy_conditions_.size()];
  const std::vector<std::size_t>& windows = sounds_[of_condition.sound].windows;
  const std::size_t window = windows[random.below(windows.size())];
  const bearing::Defect defect = info().class_of(label).defect;
  const double rpm = healthy_.speed_rpm(window);
  return {.defect = defect,
          .condition = of_condition.condition,
          .shaft_speed_rpm = rpm,
          .impact_frequency_hz = bearing::impact_frequency_hz(info().bearing, defect, rpm),
          .healthy = healthy_.window(window)};
}

const Eigen::ArrayXd& Machine::log_amplitude(std::int32_t condition) const {
  return sounds_[std::ranges::find(healthy_conditions_, condition, &HealthyCondition::condition)
                     ->sound]
      .log_amplitude;
}

signal::WindowSet make_windows(const Machine& machine, std::size_t count, const Stream& stream,
                               const Make& make) {
  const auto make_one = [&](Label label, std::size_t index, Stream& random) {
    const Scene scene = machine.draw_scene(label, index, random);
    signal::MadeWindow made = make(scene, random);
    if (!machine.info().conditions.empty()) made.condition = scene.condition;
    if (machine.has_speeds()) made.shaft_speed_rpm = scene.shaft_speed_rpm;
    return made;
  };
  return signal::make_windows(machine.info(), machine.length(), count, stream, make_one);
}

}  // namespace piae::zero
