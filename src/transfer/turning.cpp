#include "transfer/turning.hpp"

#include <algorithm>
#include <cmath>

#include "signal/passage.hpp"

namespace piae::transfer {

namespace {

signal::Waveform<double> waveform(const Turning& turning) {
  return {.samples = turning.samples, .cycle = turning.cycle};
}

/// Returns the first sample of the stretch of `length` samples with the most power.
std::size_t loudest_stretch(std::span<const double> window, std::size_t length) {
  double power = 0;
  for (std::size_t i = 0; i < length; ++i) power += window[i] * window[i];
  double most = power;
  std::size_t loudest = 0;
  for (std::size_t i = length; i < window.size(); ++i) {
    power += window[i] * window[i] - window[i - length] * window[i - length];
    if (power <= most) continue;
    most = power;
    loudest = i + 1 - length;
  }
  return loudest;
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

Turning turning_of(std::span<const double> window, const Comb& comb) {
  const signal::Cycle whole{.samples = window.size(), .strikes = 1, .blend = 0};
  const auto cycle = signal::cycle_of(comb.period, window.size());
  Turning turning{.samples = {}, .cycle = cycle.value_or(whole), .has_rhythm = cycle.has_value()};
  const std::size_t begin = loudest_stretch(window, turning.cycle.samples + turning.cycle.blend);
  turning.samples = signal::closed_cycle(window.subspan(begin), turning.cycle);
  const double period = turning.cycle.period();
  const double first = comb.first - static_cast<double>(begin);
  const double to_first_strike = first - std::floor(first / period) * period;
  const auto ahead = static_cast<std::size_t>(std::lround(to_first_strike));
  std::rotate(turning.samples.begin(),
              turning.samples.begin() + static_cast<std::ptrdiff_t>(ahead % turning.cycle.samples),
              turning.samples.end());
  return turning;
}

StruckWindow turned(const Turning& first, const Turning& second, std::size_t length,
                    Stream& random) {
  const signal::Passage passage = signal::draw_passage(first.cycle, length, random);
  StruckWindow window;
  window.samples = signal::splice(waveform(first), waveform(second), passage, length);
  if (first.has_rhythm && second.has_rhythm) {
    window.strikes = impacts_of(passage, first.cycle.period(), second.cycle.period(), length);
  }
  return window;
}

}  // namespace piae::transfer
