#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "impacts/response.hpp"
#include "impacts/synthesis.hpp"
#include "signal/window_set.hpp"
#include "support/three_classes.hpp"
#include "transfer/known_bearings.hpp"

namespace piae::transfer {

/// Returns the logarithm of the amplitude of a structure with resonances at 1.1, 2.4 and 4.2 kHz.
inline Eigen::ArrayXd three_resonances(Eigen::Index bins, double rate_hz) {
  Eigen::ArrayXd answer(bins);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double hz = rate_hz / 2 * static_cast<double>(i) / static_cast<double>(bins - 1);
    double amplitude = 0.05;
    for (const double resonance_hz : {1100.0, 2400.0, 4200.0}) {
      amplitude += 1 / (1 + std::pow((hz - resonance_hz) / 300, 2));
    }
    answer[i] = std::log(amplitude);
  }
  return answer - answer.mean();
}

/// Returns the edges of window i at this speed: the lag is `share` of the passage.
inline impacts::Edges edges_at(const signal::WindowSet& windows, std::size_t i, double share,
                               double rpm) {
  return {
      .lag_s = share * passage_s(windows, i, windows.size_mm(i), rpm), .exit = 0.6, .spread = 0.02};
}

constexpr double lag_shares[] = {0.85, 0.95, 0.9, 0.8};

/// Returns a window of 1024 samples of this structure, with impacts from a random moment on at the
/// rate of window `i`, and with cyclic strengths.
inline Eigen::ArrayXd impacts_like(const signal::WindowSet& windows, std::size_t i,
                                   std::span<const double> strengths, double rms) {
  Stream random("window " + std::to_string(i));
  const double rate_hz = windows.info.sample_rate_hz;
  const impacts::Edges edges = edges_at(windows, i, lag_shares[i / 5], 1200);
  const auto all = impacts::draw_impacts(
      random, {.period = period_s(windows, i, 1200), .jitter = 0.005}, 2048 / rate_hz,
      [&](std::size_t j) {
        return impacts::Impact{.strength = strengths[j % strengths.size()],
                               .lag_s = edges.lag_s * (1 + random.normal(0, edges.spread)),
                               .exit = edges.exit};
      });
  const Eigen::ArrayXcd response = impacts::minimum_phase(three_resonances(1025, rate_hz));
  return rms * impacts::window_of(impacts::impact_frame(all, response, rate_hz), 1024);
}

/// Returns windows of one machine with four bearings: small and large defects of inner and outer
/// race, five windows each at 1200 rpm, tested at 600 rpm. Both edges of each defect excite the
/// structure.
inline signal::WindowSet one_machine() {
  signal::WindowSet known;
  known.info = three_classes("machine");
  known.info.classes = {{"Normal", signal::Defect::none, 0},
                        {"IR5", signal::Defect::inner, 1.2},
                        {"IR8", signal::Defect::inner, 2.0},
                        {"OR5", signal::Defect::outer, 1.6},
                        {"OR8", signal::Defect::outer, 2.5}};
  known.info.conditions = {
      {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = false, .healthy = true},
      {.name = "slow", .shaft_speed_rpm = 600, .known = false, .test = true, .healthy = true}};
  known.length = 1024;
  for (std::size_t i = 0; i < 20; ++i) {
    known.labels.push_back(static_cast<Label>(1 + i / 5));
    known.condition.push_back(0);
    known.shaft_speed_rpm.push_back(1200);
  }
  const std::vector<double> alike{1};
  for (std::size_t i = 0; i < 20; ++i) {
    for (const double x : impacts_like(known, i, alike, 3)) {
      known.samples.push_back(static_cast<float>(x));
    }
  }
  return known;
}

}  // namespace piae::transfer
