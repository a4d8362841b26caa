#include "phase/cycle.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "bearing/strikes.hpp"

namespace piae::phase {

namespace {

/// At least this part of a window is left to blend the cycle's end into its beginning.
constexpr double least_blend = 1.0 / 32;
/// In samples. A longer blend would soften more of the cycle than the seam needs.
constexpr std::size_t longest_blend = 64;

}  // namespace

double strike_frequency_hz(const signal::DatasetInfo& info, Label label) {
  const signal::ClassInfo& c = info.classes.at(index_of(label));
  if (c.defect == signal::Defect::none) {
    throw Error(Exit::bad_input,
                info.name + ": class " + c.name + " has no defect, and so no fault frequency");
  }
  return bearing::strike_frequency_hz(info.bearing, c.defect, info.known_speed_rpm());
}

std::size_t Cycle::offset_of_strike(std::size_t j) const {
  return static_cast<std::size_t>(
      std::lround(static_cast<double>(j * samples) / static_cast<double>(strikes)));
}

double Cycle::angle_rad(std::size_t sample) const {
  const double turns = static_cast<double>(sample * strikes) / static_cast<double>(samples);
  return 2 * std::numbers::pi * (turns - std::floor(turns));
}

Cycle cycle_of(const signal::DatasetInfo& info, Label label, std::size_t length) {
  const double strike_samples = info.sample_rate_hz / strike_frequency_hz(info, label);
  const double usable = static_cast<double>(length) * (1 - least_blend);
  const double strikes = std::floor(usable / strike_samples);
  if (strikes < 1) {
    throw Error(
        Exit::bad_input,
        fmt::format("{}: windows of {} samples do not hold one strike of class {}, every "
                    "{:.1f} samples; longer windows would",
                    info.name, length, info.classes.at(index_of(label)).name, strike_samples));
  }
  Cycle cycle;
  cycle.strikes = static_cast<std::size_t>(strikes);
  cycle.samples = static_cast<std::size_t>(std::lround(strikes * strike_samples));
  cycle.blend = std::min({length - cycle.samples, cycle.samples, longest_blend});
  return cycle;
}

std::vector<double> closed_cycle(std::span<const double> window, const Cycle& cycle) {
  std::vector<double> waveform(window.begin(), window.begin() + cycle.samples);
  for (std::size_t i = 0; i < cycle.blend; ++i) {
    const double weight = (static_cast<double>(i) + 0.5) / static_cast<double>(cycle.blend);
    waveform[i] = weight * window[i] + (1 - weight) * window[cycle.samples + i];
  }
  return waveform;
}

}  // namespace piae::phase
