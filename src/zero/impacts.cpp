#include "zero/impacts.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/strikes.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Parts of a ball's diameter, and of a passage.
constexpr double largest_part = 0.5;
constexpr double least_passage = 0.8;
/// Of a lag, from strike to strike: standard deviation / lag.
constexpr double lag_deviation = 0.05;
/// Energy of a floor / that of a blow, the root.
constexpr double smoothest = 0.14;
constexpr double roughest = 2.8;
constexpr Index shortest_floor = 2;  // samples

}  // namespace

double largest_size_mm(const bearing::Geometry& geometry, const Prior& prior) {
  return std::min(prior.largest_size_mm, largest_part * geometry.ball_diameter_mm);
}

double draw_lag_s(const Scene& scene, const bearing::Geometry& geometry, const Prior& prior,
                  Stream& random) {
  const double largest_mm = largest_size_mm(geometry, prior);
  const double size_mm = log_evenly(random, std::min(prior.least_size_mm, largest_mm), largest_mm);
  return bearing::passage_s(geometry, {.kind = scene.defect, .size_mm = size_mm},
                            scene.shaft_speed_rpm) *
         evenly(random, least_passage, 1);
}

void add_second_edges(double lag_s, const Prior& prior, Stream& random,
                      std::vector<transfer::Strike>& strikes) {
  const double exit = evenly(random, prior.least_exit, 1);
  for (transfer::Strike& strike : strikes) {
    strike.lag_s = lag_s * (1 + random.normal(0, lag_deviation));
    strike.exit = exit;
  }
}

ArrayXd draw_rough_floor(const std::vector<transfer::Strike>& strikes, double lag_s, Index samples,
                         double rate_hz, Stream& random) {
  ArrayXd floor = ArrayXd::Zero(samples);
  const Index length = std::max(shortest_floor, static_cast<Index>(lag_s * rate_hz));
  const double roughness =
      log_evenly(random, smoothest, roughest) / std::sqrt(static_cast<double>(length));
  for (const transfer::Strike& strike : strikes) {
    const auto first = static_cast<Index>(strike.time_s * rate_hz);
    const Index end = std::min(samples, first + length);
    for (Index i = first; i < end; ++i) floor[i] += random.normal(0, strike.strength * roughness);
  }
  return floor;
}

}  // namespace piae::zero
