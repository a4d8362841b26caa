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

/// What a classifier answers of windows that do move.
using Answer = std::function<diagnosis::Answers(const signal::WindowSet&)>;

/// Judges windows one after another: an alarm, and a decision every so often.
class Judge {
 public:
  /// A decision for each `every_s` of the stream, at the end of the window that completes it; for
  /// each window where that is 0. Where the alarm is raised or cleared, there is one at once.
  Judge(const signal::DatasetInfo& info, Alarm alarm, double every_s);

  /// What was found of one window.
  struct Finding {
    double end_s = 0;                ///< of its last sample, in the stream
    std::span<const float> classes;  ///< probabilities; empty where nothing moves in the window
    bool unknown = false;
  };

  /// A window that looks like nothing known, and one in which nothing moves (a dead sensor), looks
  /// faulty; another does with the probability of all classes but the healthy one.
  std::optional<Decision> add(const Finding& finding);
  /// The windows since the last decision, at the end.
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

  // Of the windows since the last decision:
  std::size_t since_ = 0;
  std::size_t since_unknown_ = 0;
  std::vector<double> since_probabilities_;
  double end_s_ = 0;

  /// What made windows look faulty, by class and at last "unknown"; it fades within as many windows
  /// as an alarm takes at least.
  std::vector<double> causes_;

  std::size_t alarms_ = 0;
  std::size_t windows_ = 0;
  std::size_t unknown_windows_ = 0;
  std::size_t silent_windows_ = 0;
};

}  // namespace piae::monitor
