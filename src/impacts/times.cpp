#include "impacts/times.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bearing/impact_frequency.hpp"

namespace piae::impacts {

namespace {

/// Fraction of a period: the least distance of two balls.
constexpr double nearest_ball = 0.5;

constexpr double least_samples = 2;

}  // namespace

void require_rate(const signal::DatasetInfo& info, Label label, double rpm) {
  const signal::ClassInfo& c = info.class_of(label);
  const double hz = bearing::impact_frequency_hz(info.bearing, c.defect, rpm);
  if (hz * least_samples <= info.sample_rate_hz) return;
  throw Error(
      Exit::bad_input,
      fmt::format("class {} has {:g} impacts per second at {:g} rpm, too many for a sample rate "
                  "of {:g} Hz; use recordings with a higher sample rate",
                  c.name, hz, rpm, info.sample_rate_hz));
}

void for_each_impact(Stream& random, const ImpactRate& rate, double first, double end,
                     const std::function<void(double time)>& visit) {
  double time = first;
  while (time < end) {
    visit(time);
    time += rate.period * std::max(nearest_ball, 1 + random.normal(0, rate.jitter));
  }
}

std::size_t most_impacts(const ImpactRate& rate, double frame_s) {
  return static_cast<std::size_t>(std::ceil(frame_s / (nearest_ball * rate.period))) + 1;
}

std::vector<Impact> draw_impacts(Stream& random, const ImpactRate& rate, double frame_s,
                                 const std::function<Impact(std::size_t i)>& draw) {
  std::vector<Impact> impacts;
  for_each_impact(random, rate, random.uniform(0, rate.period), frame_s, [&](double time_s) {
    impacts.push_back(draw(impacts.size()));
    impacts.back().time_s = time_s;
  });
  return impacts;
}

std::vector<double> times_within(std::span<const double> samples, std::size_t length,
                                 double rate_hz) {
  const double end_s = static_cast<double>(length) / rate_hz;
  std::vector<double> times_s;
  for (const double sample : samples) {
    const double time_s = sample / rate_hz;
    if (time_s >= 0 && time_s < end_s) times_s.push_back(time_s);
  }
  return times_s;
}

}  // namespace piae::impacts
