#pragma once

#include <string>
#include <vector>

#include "monitor/decision.hpp"
#include "monitor/judge.hpp"
#include "support/three_classes.hpp"

namespace piae::monitor {

/// Returns a data set with a healthy class and two faults, at 1000 Hz.
inline signal::DatasetInfo rig() {
  signal::DatasetInfo info = three_classes("rig");
  info.sample_rate_hz = 1000;
  info.shaft_speed_rpm = 1500;
  return info;
}

/// Options with which three faulty-looking windows raise the alarm and three others clear it, at 64
/// windows an hour (alarm_test.cpp).
inline const AlarmOptions three_windows{
    .healthy_share = 0.2, .faulty_share = 0.8, .hours_per_false_alarm = 1};

/// Returns "time class state cause; " for each decision, with '?' if it is unknown.
inline std::string text_of(const std::vector<Decision>& decisions) {
  std::string text;
  for (const Decision& d : decisions) {
    text += std::to_string(d.time_s).substr(0, 4) + " " +
            (d.label ? rig().class_of(*d.label).name : "-") + (d.unknown ? "?" : "") + " " +
            to_string(d.alarm) + (d.cause.empty() ? "" : " " + d.cause) + "; ";
  }
  return text;
}

}  // namespace piae::monitor
