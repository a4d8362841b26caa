#include "signal/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace piae::signal {

namespace {

/// Smallest part of a window that is left to blend the cycle's end into its start.
constexpr double least_blend = 1.0 / 32;
/// Longest blend, in samples. A longer one would soften more of the cycle than the seam needs.
constexpr std::size_t longest_blend = 64;

}  // namespace

std::size_t Cycle::offset_of_impact(std::size_t j) const {
  return static_cast<std::size_t>(
      std::lround(static_cast<double>(j * samples) / static_cast<double>(impacts)));
}

double Cycle::angle_rad(std::size_t sample) const {
  const double turns = static_cast<double>(sample * impacts) / static_cast<double>(samples);
  return 2 * std::numbers::pi * (turns - std::floor(turns));
}

double Cycle::period() const { return static_cast<double>(samples) / static_cast<double>(impacts); }

std::optional<Cycle> cycle_of(double period, std::size_t length) {
  const double usable = static_cast<double>(length) * (1 - least_blend);
  const double impacts = std::floor(usable / period);
  if (impacts < 1) return std::nullopt;
  Cycle cycle;
  cycle.impacts = static_cast<std::size_t>(impacts);
  cycle.samples = static_cast<std::size_t>(std::lround(impacts * period));
  cycle.blend = std::min({length - cycle.samples, cycle.samples, longest_blend});
  return cycle;
}

std::vector<double> closed_cycle(std::span<const double> window, const Cycle& cycle) {
  std::vector<double> waveform(window.begin(),
                               window.begin() + static_cast<std::ptrdiff_t>(cycle.samples));
  for (std::size_t i = 0; i < cycle.blend; ++i) {
    const double weight = (static_cast<double>(i) + 0.5) / static_cast<double>(cycle.blend);
    waveform[i] = weight * window[i] + (1 - weight) * window[cycle.samples + i];
  }
  return waveform;
}

}  // namespace piae::signal
