#include "transfer/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace piae::transfer {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Parts of half the sampling rate: where the tilt of a spectrum begins, and where it changes
/// nothing.
constexpr double tilt_from = 0.05;
constexpr double tilt_about = 1.0 / 6;

ArrayXd draw_phase(Stream& random, Index bins, double rate_hz, const CarryOptions& options) {
  std::vector<double> knots_s(static_cast<std::size_t>(options.equaliser.knots));
  for (double& knot_s : knots_s) knot_s = random.normal(0, options.dispersion_ms / 1e3);
  const double knots_per_bin =
      static_cast<double>(knots_s.size() - 1) / static_cast<double>(bins - 1);
  const double turn = std::numbers::pi * rate_hz / static_cast<double>(bins - 1);  // 2 pi bin
  ArrayXd phase(bins);
  double sum = 0;
  for (Index i = 0; i < bins; ++i) {
    phase[i] = sum;
    const double place = static_cast<double>(i) * knots_per_bin;
    const auto below = std::min(static_cast<std::size_t>(place), knots_s.size() - 2);
    sum -= turn * std::lerp(knots_s[below], knots_s[below + 1], place - static_cast<double>(below));
  }
  return phase;
}

}  // namespace

Path draw_path(Stream& random, Index bins, double rate_hz, double speed_ratio,
               bool to_other_bearing, const CarryOptions& options) {
  const double power = random.uniform(0, 1) * options.tilt * std::log2(speed_ratio);
  EqualiserOptions equaliser = options.equaliser;
  if (to_other_bearing) equaliser.spread_db = options.other_bearing_db;
  const std::vector<double> gains = draw_gains(random, static_cast<std::size_t>(bins), equaliser);
  ArrayXd log_gain(bins);
  for (Index i = 0; i < bins; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(bins - 1);
    log_gain[i] = std::log(gains[static_cast<std::size_t>(i)]) +
                  power * std::log(std::max(part, tilt_from) / tilt_about);
  }
  return {.log_gain = log_gain, .phase = draw_phase(random, bins, rate_hz, options)};
}

}  // namespace piae::transfer
