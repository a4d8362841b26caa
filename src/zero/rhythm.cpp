#include "zero/rhythm.hpp"

#include "transfer/strike_train.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

/// The largest jitter / the least.
constexpr double jitter_span = 7;

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
  transfer::for_each_strike(random, rhythm.period_s, rhythm.jitter, frame_s,
                            [&](double time_s) { strikes.push_back({.time_s = time_s}); });
  return strikes;
}

}  // namespace piae::zero
