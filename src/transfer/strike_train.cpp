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

void for_each_strike(Stream& random, double period_s, double jitter, double frame_s,
                     const std::function<void(double time_s)>& strike) {
  double time_s = random.uniform(0, period_s);
  while (time_s < frame_s) {
    strike(time_s);
    time_s += period_s * std::max(nearest_ball, 1 + random.normal(0, jitter));
  }
}

std::vector<Strike> draw_strikes(Stream& random, const Rhythm& rhythm,
                                 std::span<const double> strengths, double frame_s) {
  std::vector<Strike> strikes;
  for_each_strike(random, rhythm.period_s, rhythm.jitter, frame_s, [&](double time_s) {
    strikes.push_back({.time_s = time_s,
                       .strength = strengths[strikes.size()],
                       .lag_s = rhythm.edges.lag_s * (1 + random.normal(0, rhythm.edges.spread)),
                       .exit = rhythm.edges.exit});
  });
  return strikes;
}

std::vector<double> times_within(std::span<const double> strikes, std::size_t length,
                                 double rate_hz) {
  const double end_s = static_cast<double>(length) / rate_hz;
  std::vector<double> times_s;
  for (const double strike : strikes) {
    const double time_s = strike / rate_hz;
    if (time_s >= 0 && time_s < end_s) times_s.push_back(time_s);
  }
  return times_s;
}

}  // namespace piae::transfer
