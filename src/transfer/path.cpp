#include "transfer/path.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "impacts/response.hpp"

namespace piae::transfer {

namespace {

using Eigen::ArrayXcd;
using Eigen::ArrayXd;
using Eigen::Index;

/// Fractions of half the sampling rate: where the tilt of a spectrum begins, and where its gain is
/// 1.
constexpr double tilt_from = 0.05;
constexpr double tilt_about = 1.0 / 6;

ArrayXd draw_phase(Stream& random, Index bins, double rate_hz, const CarryOptions& options) {
  std::vector<double> knots_s(static_cast<std::size_t>(options.equaliser.knots));
  for (double& knot_s : knots_s) knot_s = random.normal(0, options.dispersion_ms / 1e3);
  const double turn = std::numbers::pi * rate_hz / static_cast<double>(bins - 1);  // 2 pi bin
  ArrayXd phase(bins);
  double sum = 0;
  for (Index i = 0; const double delay_s : impacts::along_knots(knots_s, bins)) {
    phase[i++] = sum;
    sum -= turn * delay_s;
  }
  return phase;
}

}  // namespace

Path draw_path(Stream& random, Index bins, double rate_hz, double speed_ratio,
               bool to_other_bearing, const CarryOptions& options) {
  const double power = random.uniform(0, 1) * options.tilt * std::log2(speed_ratio);
  impacts::EqualiserOptions equaliser = options.equaliser;
  if (to_other_bearing) equaliser.spread_db = options.other_bearing_db;
  const ArrayXd gains = impacts::draw_gains(random, bins, equaliser);
  ArrayXd log_gain(bins);
  for (Index i = 0; i < bins; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(bins - 1);
    log_gain[i] = std::log(gains[i]) + power * std::log(std::max(part, tilt_from) / tilt_about);
  }
  return {.log_gain = log_gain, .phase = draw_phase(random, bins, rate_hz, options)};
}

ArrayXcd response_behind(const Path& path, const ArrayXd& log_response) {
  const std::complex<double> i(0, 1);
  return impacts::minimum_phase(log_response + path.log_gain) *
         (i * path.phase.cast<std::complex<double>>()).exp();
}

}  // namespace piae::transfer
