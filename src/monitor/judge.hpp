#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnosis/kept_classifier.hpp"
#include "monitor/alarm.hpp"
#include "monitor/decision.hpp"

namespace piae::monitor {

/// Callback that classifies windows. Constant ones are removed first.
using Predict = std::function<diagnosis::Predictions(const signal::WindowSet&)>;

/// Judges successive windows: updates the alarm and makes a decision at regular intervals.
class Judge {
 public:
  /// Decides once per `every_s` seconds of the stream, at the end of the window that completes
  /// them. If `every_s` is 0, decides after each window. Also decides as soon as the alarm is
  /// raised or cleared.
  Judge(const signal::DatasetInfo& info, Alarm alarm, double every_s);

  /// Classifier's output for one window.
  struct Finding {
    double end_s = 0;                ///< time of its last sample in the stream
    std::span<const float> classes;  ///< probabilities; empty if the window is constant
    bool unknown = false;
  };

  /// Adds a window; returns a decision if one is due. Unknown and constant windows (a dead sensor)
  /// count as faulty. Other windows count with 1 less the probability of the healthy class.
  std::optional<Decision> add(const Finding& finding);
  /// Decides on the windows since the last decision, at the end of the stream.
  std::optional<Decision> finish();

  [[nodiscard]] std::size_t alarms() const { return alarms_; }
  [[nodiscard]] std::size_t windows() const { return windows_; }
  [[nodiscard]] std::size_t unknown_windows() const { return unknown_windows_; }
  [[nodiscard]] std::size_t silent_windows() const { return silent_windows_; }

 private:
  void remember_cause(const Finding& finding);
  [[nodiscard]] std::string cause() const;
  [[nodiscard]] Decision decide();

  signal::DatasetInfo info_;
  Label healthy_;
  Alarm alarm_;
  double every_s_;
  double next_s_;

  // State since the last decision:
  std::size_t since_ = 0;
  std::size_t since_unknown_ = 0;
  std::vector<double> since_probabilities_;
  double end_s_ = 0;

  /// Fault evidence of each class and, in the last element, of "unknown". Fades over the smallest
  /// number of windows that raise an alarm.
  std::vector<double> causes_;

  std::size_t alarms_ = 0;
  std::size_t windows_ = 0;
  std::size_t unknown_windows_ = 0;
  std::size_t silent_windows_ = 0;
};

}  // namespace piae::monitor
