#include "diffusion/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace piae::diffusion {

namespace {

/// Offset of the cosine schedule, which keeps its first steps from being too small.
constexpr double offset = 0.008;

/// Returns s(u) of the cosine schedule, from 0 to pi / 2.
double angle_at(double u) {
  const auto cosine = [](double at) {
    return std::cos((at + offset) / (1 + offset) * std::numbers::pi / 2);
  };
  return std::acos(std::clamp(cosine(u) / cosine(0), 0.0, 1.0));
}

}  // namespace

Point point_at(Path path, double u) {
  if (path == Path::flow) {
    return {.data = 1 - u, .noise = u, .velocity_of_data = -1, .velocity_of_noise = 1};
  }
  const double s = angle_at(u);
  return {.data = std::cos(s),
          .noise = std::sin(s),
          .velocity_of_data = -std::sin(s),
          .velocity_of_noise = std::cos(s)};
}

Move move_between(Path path, double from, double to) {
  if (path == Path::flow) return {.of_x = 1, .of_velocity = to - from};
  const double turn = angle_at(to) - angle_at(from);
  return {.of_x = std::cos(turn), .of_velocity = std::sin(turn)};
}

}  // namespace piae::diffusion
