#include "transfer/turning.hpp"

#include <algorithm>
#include <cmath>

#include "signal/passage.hpp"

namespace piae::transfer {

namespace {

signal::Waveform<double> waveform(const Turning& turning) {
  return {.samples = turning.samples, .cycle = turning.cycle};
}

/// Appends the strikes of a window's samples `from` to `to`, of which the first is sample `at` of
/// the cycle.
void append_strikes(std::vector<double>& strikes, const Turning& turning, std::size_t at,
                    std::size_t from, std::size_t to) {
  if (!turning.is_struck) return;
  const double period = turning.cycle.period();
  const double since = std::fmod(static_cast<double>(at % turning.cycle.samples), period);
  double next = static_cast<double>(from) + (since > 0 ? period - since : 0);
  while (next < static_cast<double>(to)) {
    strikes.push_back(next);
    next += period;
  }
}

}  // namespace

Turning turning_of(std::span<const double> window, const Comb& comb) {
  const signal::Cycle whole{.samples = window.size(), .strikes = 1, .blend = 0};
  Turning turning;
  turning.cycle = signal::cycle_of(comb.period, window.size()).value_or(whole);
  turning.samples = signal::closed_cycle(window, turning.cycle);
  turning.is_struck = comb.first < static_cast<double>(window.size());
  const auto first = static_cast<std::size_t>(std::lround(comb.first)) % turning.cycle.samples;
  std::rotate(turning.samples.begin(), turning.samples.begin() + static_cast<std::ptrdiff_t>(first),
              turning.samples.end());
  return turning;
}

StruckWindow turned(const Turning& first, const Turning& second, std::size_t length,
                    Stream& random) {
  const signal::Passage passage = signal::draw_passage(first.cycle, length, random);
  StruckWindow window;
  window.samples = signal::splice(waveform(first), waveform(second), passage, length);
  append_strikes(window.strikes, first, passage.start, 0, passage.change);
  append_strikes(window.strikes, second,
                 signal::sample_after_change(first.cycle, second.cycle, passage), passage.change,
                 length);
  return window;
}

}  // namespace piae::transfer
