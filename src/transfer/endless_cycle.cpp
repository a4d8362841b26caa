#include "transfer/endless_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "signal/passage.hpp"

namespace piae::transfer {

namespace {

signal::Waveform<double> waveform(const EndlessCycle& endless) {
  return {.samples = endless.samples, .cycle = endless.cycle};
}

/// Returns the first sample of the stretch of `length` samples with the most power.
std::size_t strongest_stretch(std::span<const double> window, std::size_t length) {
  double power = 0;
  for (std::size_t i = 0; i < length; ++i) power += window[i] * window[i];
  double most = power;
  std::size_t strongest = 0;
  for (std::size_t i = length; i < window.size(); ++i) {
    power += window[i] * window[i] - window[i - length] * window[i - length];
    if (power <= most) continue;
    most = power;
    strongest = i + 1 - length;
  }
  return strongest;
}

/// Appends a position for each period from `next` to `end`. Returns the first position beyond.
double append_regular(double next, double end, double period, std::vector<double>& places) {
  for (; next < end; next += period) places.push_back(next);
  return next;
}

/// Returns the impacts of a window that passes from one rate to another. The phase within the
/// period continues at the change, so no impact is doubled or missing.
std::vector<double> impacts_of(const signal::Passage& passage, double first_period,
                               double second_period, std::size_t length) {
  std::vector<double> impacts;
  const auto change = static_cast<double>(passage.change);
  const double since = std::fmod(static_cast<double>(passage.start), first_period);
  const double first = since > 0 ? first_period - since : 0;
  const double next = append_regular(first, change, first_period, impacts);
  append_regular(change + (next - change) / first_period * second_period,
                 static_cast<double>(length), second_period, impacts);
  return impacts;
}

}  // namespace

EndlessCycle endless_cycle_of(std::span<const double> window, const Comb& comb) {
  const signal::Cycle whole{.samples = window.size(), .impacts = 1, .blend = 0};
  const auto cycle = signal::cycle_of(comb.period, window.size());
  EndlessCycle endless{
      .samples = {}, .cycle = cycle.value_or(whole), .has_whole_period = cycle.has_value()};
  const std::size_t begin = strongest_stretch(window, endless.cycle.samples + endless.cycle.blend);
  endless.samples = signal::closed_cycle(window.subspan(begin), endless.cycle);
  const double period = endless.cycle.period();
  const double first = comb.first - static_cast<double>(begin);
  const double to_first_impact = first - std::floor(first / period) * period;
  const auto ahead = static_cast<std::size_t>(std::lround(to_first_impact));
  std::rotate(endless.samples.begin(),
              endless.samples.begin() + static_cast<std::ptrdiff_t>(ahead % endless.cycle.samples),
              endless.samples.end());
  return endless;
}

ImpactWindow window_of_cycles(const EndlessCycle& first, const EndlessCycle& second,
                              std::size_t length, Stream& random) {
  const signal::Passage passage = signal::draw_passage(first.cycle, length, random);
  ImpactWindow window;
  window.samples = signal::splice(waveform(first), waveform(second), passage, length);
  if (first.has_whole_period && second.has_whole_period) {
    window.impact_positions =
        impacts_of(passage, first.cycle.period(), second.cycle.period(), length);
  }
  return window;
}

}  // namespace piae::transfer
