#include "transfer/strike_train.hpp"

#include <algorithm>

namespace piae::transfer {

namespace {

/// Of a period: the ball before is never nearer.
constexpr double nearest_ball = 0.5;

}  // namespace

std::size_t most_strikes(const Rhythm& rhythm, double frame_s) {
  return static_cast<std::size_t>(std::ceil(frame_s / (nearest_ball * rhythm.period_s))) + 1;
}

std::vector<Strike> draw_strikes(Stream& random, const Rhythm& rhythm,
                                 std::span<const double> strengths, double frame_s) {
  double time_s = random.uniform(0, rhythm.period_s);
  std::vector<Strike> strikes;
  while (time_s < frame_s) {
    strikes.push_back({.time_s = time_s,
                       .strength = strengths[strikes.size()],
                       .lag_s = rhythm.edges.lag_s * (1 + random.normal(0, rhythm.edges.spread)),
                       .exit = rhythm.edges.exit});
    time_s += rhythm.period_s * std::max(nearest_ball, 1 + random.normal(0, rhythm.jitter));
  }
  return strikes;
}

}  // namespace piae::transfer
