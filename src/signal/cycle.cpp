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

std::size_t Cycle::offset_of_strike(std::size_t j) const {
  return static_cast<std::size_t>(
      std::lround(static_cast<double>(j * samples) / static_cast<double>(strikes)));
}

double Cycle::angle_rad(std::size_t sample) const {
  const double turns = static_cast<double>(sample * strikes) / static_cast<double>(samples);
  return 2 * std::numbers::pi * (turns - std::floor(turns));
}

double Cycle::period() const { return static_cast<double>(samples) / static_cast<double>(strikes); }

std::optional<Cycle> cycle_of(double period, std::size_t length) {
  const double usable = static_cast<double>(length) * (1 - least_blend);
  const double strikes = std::floor(usable / period);
  if (strikes < 1) return std::nullopt;
  Cycle cycle;
  cycle.strikes = static_cast<std::size_t>(strikes);
  cycle.samples = static_cast<std::size_t>(std::lround(strikes * period));
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
