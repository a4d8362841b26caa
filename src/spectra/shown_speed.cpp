#include "spectra/shown_speed.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace piae::spectra {

std::string other_speed(const std::optional<ShaftSpeed>& shaft, double given_rpm) {
  constexpr double equal_within = 0.01;
  if (!shaft || !shaft->is_certain()) return "";
  const double excess = shaft->rpm / given_rpm - 1;
  if (std::abs(excess) <= equal_within) return "";
  return fmt::format("the shaft seems to turn at {:.0f} rpm, {:.1f} % {}", shaft->rpm,
                     100 * std::abs(excess), excess > 0 ? "above" : "below");
}

}  // namespace piae::spectra
