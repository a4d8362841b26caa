#include "page/duration.hpp"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <ctime>

namespace piae::page {

std::string duration_label(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
  const double minutes = seconds / 60;
  return minutes < 99.5 ? fmt::format("{:.1f} min", minutes)
                        : fmt::format("{:.1f} h", minutes / 60);
}

std::string moment_label(double seconds_since_1970) {
  const auto seconds = static_cast<std::time_t>(seconds_since_1970);
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(seconds));
}

}  // namespace piae::page
