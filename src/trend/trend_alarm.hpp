#pragma once

#include "monitor/alarm.hpp"

namespace piae::trend {

/// Sums how far a rise exceeds its limit, over time: Page's CUSUM test (1954) of a mean with the
/// limit as its reference value, in dB h. The evidence stays between 0 and the threshold. The alarm
/// is raised at the threshold, and cleared when the evidence has returned to 0. A window adds at
/// most half the threshold in either direction, so that no single one raises or clears an alarm,
/// after however long a time it comes.
class TrendAlarm {
 public:
  explicit TrendAlarm(double threshold_db_h) : threshold_db_h_(threshold_db_h) {}

  /// Adds a window: how far it exceeds its limit in dB, which may be infinite, and the time since
  /// the previous window. Returns the new state.
  monitor::AlarmState add(double excess_db, double hours);

  [[nodiscard]] monitor::AlarmState state() const { return state_; }
  /// Returns the evidence as a share of the threshold.
  [[nodiscard]] double evidence() const { return evidence_db_h_ / threshold_db_h_; }

 private:
  double threshold_db_h_;
  double evidence_db_h_ = 0;
  monitor::AlarmState state_ = monitor::AlarmState::off;
};

}  // namespace piae::trend
