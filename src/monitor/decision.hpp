#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/label.hpp"
#include "monitor/alarm.hpp"
#include "signal/dataset_info.hpp"

namespace piae::monitor {

/// What is to be said of one or more windows that follow each other.
struct Decision {
  double time_s = 0;  ///< of the end of the last window, counted in samples from the first one
  std::size_t windows = 0;
  std::optional<Label> label;  ///< the class of the greatest mean probability; none without signal
  double probability = 0;      ///< that mean
  bool unknown = false;        ///< more than half of the windows look like nothing that was trained
  double evidence = 0;         ///< for the alarm, as a share of what raises it
  AlarmState alarm = AlarmState::off;
  /// While the alarm is on, what it is for: a class, or "unknown".
  std::string cause;
};

/// One line of JSON, with its end:
///     {"time_s": 2.048, "windows": 12, "class": "OR007", "probability": 0.981, "unknown": false,
///      "evidence": 1, "alarm": "raised", "cause": "OR007"}
/// `class` and `cause` may be null.
std::string json_line(const Decision& decision, const signal::DatasetInfo& info);

}  // namespace piae::monitor
