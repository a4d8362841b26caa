#include "signal/speed_course.hpp"

#include <algorithm>
#include <cmath>

namespace piae::signal {

namespace {

constexpr double usual_block_s = 0.02;  // shorter than a turn up to 3000 rpm
constexpr double seconds_a_minute = 60;

/// Returns the turns at a time, by the segment that holds it or is nearest. `segment` is the index
/// of that of an earlier time, and is moved on.
double turns_at(const ShaftAngle& angle, double time_s, std::size_t& segment) {
  while (segment + 2 < angle.time_s.size() && angle.time_s[segment + 1] <= time_s) ++segment;
  const double share =
      (time_s - angle.time_s[segment]) / (angle.time_s[segment + 1] - angle.time_s[segment]);
  return std::lerp(angle.turns[segment], angle.turns[segment + 1], share);
}

}  // namespace

double SpeedCourse::mean_rpm(double from_s, double to_s) const {
  const auto last = rpm.size() - 1;
  const auto block_at = [&](double time_s) {
    return std::min(last, static_cast<std::size_t>(std::max(0.0, std::floor(time_s / block_s))));
  };
  double sum = 0;
  for (std::size_t block = block_at(from_s); block <= block_at(to_s); ++block) {
    const double begins_s = block == 0 ? from_s : static_cast<double>(block) * block_s;
    const double ends_s = block == last ? to_s : static_cast<double>(block + 1) * block_s;
    sum += rpm[block] * (std::min(to_s, ends_s) - std::max(from_s, begins_s));
  }
  return sum / (to_s - from_s);
}

double SpeedCourse::mean_rpm(std::size_t first, std::size_t count, double rate_hz) const {
  return mean_rpm(static_cast<double>(first) / rate_hz,
                  static_cast<double>(first + count) / rate_hz);
}

SpeedCourse speed_course(const ShaftAngle& angle, double duration_s, double least_block_s) {
  constexpr double rounding = 1e-9;
  SpeedCourse course{.block_s = std::max(usual_block_s, least_block_s), .rpm = {}};
  const auto blocks =
      static_cast<std::size_t>(std::max(1.0, std::ceil(duration_s / course.block_s - rounding)));
  std::size_t segment = 0;
  double begins_s = 0;
  double begins_at = turns_at(angle, 0, segment);
  for (std::size_t block = 1; block <= blocks; ++block) {
    const double ends_s =
        block == blocks ? duration_s : static_cast<double>(block) * course.block_s;
    const double ends_at = turns_at(angle, ends_s, segment);
    course.rpm.push_back(seconds_a_minute * (ends_at - begins_at) / (ends_s - begins_s));
    begins_s = ends_s;
    begins_at = ends_at;
  }
  return course;
}

}  // namespace piae::signal
