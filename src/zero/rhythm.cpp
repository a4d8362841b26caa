#include "zero/rhythm.hpp"

#include <algorithm>

#include "zero/draws.hpp"

namespace piae::zero {

namespace {

/// The largest jitter / the least.
constexpr double jitter_span = 7;
/// Of a period: the ball before is never nearer.
constexpr double least_step = 0.5;

}  // namespace

Rhythm draw_rhythm(const Scene& scene, const Prior& prior, Stream& random) {
  const double slip = evenly(random, -prior.slip, prior.slip);
  const double jitter = scene.defect == bearing::Defect::roller ? prior.ball_jitter : prior.jitter;
  return {.period_s = 1 / (scene.strike_hz * (1 + slip)),
          .slip = slip,
          .jitter = log_evenly(random, jitter / jitter_span, jitter)};
}

std::vector<transfer::Strike> regular_strikes(const Rhythm& rhythm, double frame_s,
                                              Stream& random) {
  std::vector<transfer::Strike> strikes;
  double time_s = random.uniform(0, rhythm.period_s);
  while (time_s < frame_s) {
    strikes.push_back({.time_s = time_s});
    time_s += rhythm.period_s * std::max(least_step, 1 + random.normal(0, rhythm.jitter));
  }
  return strikes;
}

}  // namespace piae::zero
