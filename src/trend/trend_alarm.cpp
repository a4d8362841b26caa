#include "trend/trend_alarm.hpp"

#include <algorithm>

namespace piae::trend {

using monitor::AlarmState;

AlarmState TrendAlarm::add(double excess_db, double hours) {
  const double most = threshold_db_h_ / 2;
  const double gain = std::clamp(excess_db * hours, -most, most);
  evidence_db_h_ = std::clamp(evidence_db_h_ + gain, 0.0, threshold_db_h_);
  const bool is_on = state_ == AlarmState::raised || state_ == AlarmState::on;
  if (is_on) {
    state_ = evidence_db_h_ <= 0 ? AlarmState::cleared : AlarmState::on;
  } else {
    state_ = evidence_db_h_ >= threshold_db_h_ ? AlarmState::raised : AlarmState::off;
  }
  return state_;
}

}  // namespace piae::trend
