#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "monitor/alarm.hpp"

namespace piae::trend {

/// State of a machine after one or more successive windows.
struct TrendPoint {
  double time_s = 0;        ///< end of the last window
  std::size_t windows = 0;  ///< since the last point
  /// Mean rises above the healthy windows, in dB: of the RMS, and of the watched features [7 or 10]
  /// (Features::watched_db). Mean novelty; above 1 is new. None if all windows were constant.
  struct Rises {
    double level_db = 0;
    Eigen::ArrayXd watched_db;
    double novelty = 0;
  };
  std::optional<Rises> rises = std::nullopt;
  double evidence = 0;  ///< share of the alarm's threshold
  monitor::AlarmState alarm = monitor::AlarmState::off;
  std::string cause = {};  ///< feature that contributed most while the alarm is on, or "no signal"
};

/// Returns one line of JSON with its line end. `names` are those of the watched features:
///     {"time_s": 17300.1, "windows": 1, "level_db": 2.31, "rise_db": 9.04, "feature": "0-400 Hz",
///      "line_db": 1.70, "line": "outer", "novelty": 0.98, "evidence": 1, "alarm": "raised",
///      "cause": "0-400 Hz"}
/// `rise_db` and `line_db` are those of the level and the line that rose most.
std::string json_line(const TrendPoint& point, const std::vector<std::string>& names);

}  // namespace piae::trend
