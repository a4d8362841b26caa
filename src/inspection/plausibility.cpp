#include "inspection/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace piae::inspection {

bool looks_like_hz(double shaft_speed_rpm) {
  return shaft_speed_rpm >= 1 && shaft_speed_rpm <= 100;
}

std::optional<RacewayMismatch> raceway_mismatch(const bearing::Geometry& g) {
  constexpr double allowed = 0.1;  // of the ball's diameter
  const double cosine = std::cos(g.contact_angle_deg * std::numbers::pi / 180);
  RacewayMismatch mismatch;
  mismatch.gap_mm = (g.outer_raceway_mm - g.inner_raceway_mm) / 2;
  mismatch.mean_mm = (g.outer_raceway_mm + g.inner_raceway_mm) / 2;
  const double gap = mismatch.gap_mm / g.ball_diameter_mm;
  const double shift = std::abs(mismatch.mean_mm - g.pitch_diameter_mm) / g.ball_diameter_mm;
  mismatch.too_wide = gap > 1 + allowed;
  mismatch.too_tight = gap < cosine - allowed;
  if (mismatch.too_wide || mismatch.too_tight || shift > allowed) return mismatch;
  return std::nullopt;
}

double share_that_meets_training(std::size_t stride, std::size_t window, std::size_t windows,
                                 std::size_t training) {
  const std::size_t others = windows - 1;
  const std::size_t overlapping = std::min(others, 2 * ((window - 1) / stride));
  double none = 1;
  for (std::size_t i = 0; i < training; ++i) {
    if (i + overlapping >= others) return 1;
    none *= static_cast<double>(others - overlapping - i) / static_cast<double>(others - i);
  }
  return 1 - none;
}

}  // namespace piae::inspection
