#include "transfer/strike_train.hpp"

#include <algorithm>

namespace piae::transfer {

namespace {

/// Of a period: the ball before is never nearer.
constexpr double nearest_ball = 0.5;

}  // namespace

std::vector<Strike> draw_strikes(Stream& random, const Rhythm& rhythm,
                                 std::span<const double> strengths, double frame_s) {
  std::size_t next = random.below(strengths.size());
  double time_s = random.uniform(0, rhythm.period_s);
  std::vector<Strike> strikes;
  while (time_s < frame_s) {
    strikes.push_back({.time_s = time_s,
                       .strength = strengths[next],
                       .lag_s = rhythm.edges.lag_s * (1 + random.normal(0, rhythm.edges.spread)),
                       .exit = rhythm.edges.exit});
    next = (next + 1) % strengths.size();
    time_s += rhythm.period_s * std::max(nearest_ball, 1 + random.normal(0, rhythm.jitter));
  }
  return strikes;
}

}  // namespace piae::transfer
