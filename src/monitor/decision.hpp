#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/label.hpp"
#include "monitor/alarm.hpp"
#include "signal/dataset_info.hpp"

namespace piae::monitor {

/// Result for one or more successive windows.
struct Decision {
  double time_s = 0;  ///< end of the last window, counted in samples from the first one
  std::size_t windows = 0;
  std::optional<Label> label;  ///< class with the highest mean probability; none without signal
  double probability = 0;      ///< mean probability of `label`
  bool unknown = false;        ///< true if most windows are silent or like no known class
  double evidence = 0;         ///< share of the alarm's threshold
  AlarmState alarm = AlarmState::off;
  /// Reason while the alarm is on: a class name or "unknown".
  std::string cause;
};

/// Returns one line of JSON with its line end:
///     {"time_s": 2.048, "windows": 12, "class": "OR007", "probability": 0.981, "unknown": false,
///      "evidence": 1, "alarm": "raised", "cause": "OR007"}
/// `class` and `cause` may be null.
std::string json_line(const Decision& decision, const signal::DatasetInfo& info);

}  // namespace piae::monitor
