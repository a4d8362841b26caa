#include "zero/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/impact_frequency.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Ratio of the largest jitter to the least.
constexpr double jitter_span = 7;
/// Fractions of a ball's diameter and of a passage.
constexpr double largest_part = 0.5;
constexpr double least_passage = 0.8;
/// Variation from impact to impact: standard deviation / lag.
constexpr double lag_deviation = 0.05;
/// Root of the ratio of a rough floor's energy to an impact's energy.
constexpr double smoothest = 0.14;
constexpr double roughest = 2.8;
constexpr Index shortest_floor = 2;  // samples

}  // namespace

impacts::ImpactRate draw_rate(const Scene& scene, double slip, const Prior& prior, Stream& random) {
  const double jitter = scene.defect == bearing::Defect::roller ? prior.ball_jitter : prior.jitter;
  return {.period = 1 / (scene.impact_frequency_hz * (1 + slip)),
          .jitter = log_evenly(random, jitter / jitter_span, jitter)};
}

impacts::Load draw_load(bearing::Defect defect, const bearing::Speeds& speeds, const Prior& prior,
                        Stream& random) {
  const double half_turn = std::numbers::pi;
  const double widest = defect == bearing::Defect::outer ? prior.outer_angle_rad : half_turn;
  const double extent = log_evenly(random, prior.load.least_extent, prior.load.largest_extent);
  const double angle_rad = evenly(random, -widest, widest);
  impacts::Load load = impacts::load_on(defect, speeds, random.uniform(0, 1) * prior.load.rotating);
  load.extent = prior.load_zone == Switch::off ? 0 : extent;
  load.angle_rad = angle_rad;
  load.shaft_angle_rad = random.uniform(0, 2 * half_turn);
  return load;
}

double largest_size_mm(const bearing::Geometry& geometry, const Prior& prior) {
  return std::min(prior.largest_size_mm, largest_part * geometry.ball_diameter_mm);
}

double draw_lag_s(const Scene& scene, const bearing::Geometry& geometry, const Prior& prior,
                  Stream& random) {
  const double largest_mm = largest_size_mm(geometry, prior);
  const double size_mm = log_evenly(random, std::min(prior.least_size_mm, largest_mm), largest_mm);
  return bearing::passage_s(geometry, {.fault_type = scene.defect, .size_mm = size_mm},
                            scene.shaft_speed_rpm) *
         evenly(random, least_passage, 1);
}

void add_second_edges(double lag_s, const Prior& prior, Stream& random,
                      std::vector<impacts::Impact>& impacts) {
  const double exit = evenly(random, prior.least_exit, 1);
  for (impacts::Impact& impact : impacts) {
    impact.lag_s = lag_s * (1 + random.normal(0, lag_deviation));
    impact.exit = exit;
  }
}

ArrayXd draw_rough_floor(const std::vector<impacts::Impact>& impacts, double lag_s, Index samples,
                         double rate_hz, Stream& random) {
  ArrayXd floor = ArrayXd::Zero(samples);
  const Index length = std::max(shortest_floor, static_cast<Index>(lag_s * rate_hz));
  const double roughness =
      log_evenly(random, smoothest, roughest) / std::sqrt(static_cast<double>(length));
  for (const impacts::Impact& impact : impacts) {
    const auto first = static_cast<Index>(impact.time_s * rate_hz);
    const Index end = std::min(samples, first + length);
    for (Index i = first; i < end; ++i) floor[i] += random.normal(0, impact.strength * roughness);
  }
  return floor;
}

}  // namespace piae::zero
