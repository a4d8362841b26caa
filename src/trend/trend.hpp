#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trend/features.hpp"
#include "trend/healthy.hpp"
#include "trend/options.hpp"
#include "trend/timed_window.hpp"
#include "trend/trend_alarm.hpp"
#include "trend/trend_point.hpp"

namespace piae::trend {

/// Compares the windows of a machine with its first, healthy hours, and raises an alarm after one
/// of the watched features has risen far enough for long enough.
class Trend {
 public:
  /// Takes the windows that start in the first `healthy_h` hours as healthy. Reports a point every
  /// `every_s` seconds, at the end of the window that completes them; after each window if 0, and
  /// as soon as the alarm is raised or cleared.
  Trend(FeatureMeter meter, const TrendOptions& options, double healthy_h, double every_s);
  /// Takes a baseline that was kept instead.
  Trend(Baseline baseline, const TrendOptions& options, double every_s);

  using Report = std::function<void(const TrendPoint&)>;

  /// Adds the next window. A constant window after the healthy hours (a dead sensor)
  /// counts as faulty; in these hours it is left out. Throws Error(bad_input) if the healthy hours
  /// end with too few windows.
  void add(const TimedWindow& window, const Report& report);
  /// Reports the windows since the last point, at the end. Makes the baseline if the healthy hours
  /// end here.
  void finish(const Report& report);

  [[nodiscard]] const FeatureMeter& meter() const { return meter_; }
  /// Returns the baseline; nothing before the end of the healthy hours.
  [[nodiscard]] const std::optional<Healthy>& healthy() const { return healthy_; }
  /// Returns the healthy windows as points without an alarm, by their times; nothing for a kept
  /// baseline.
  [[nodiscard]] std::vector<TrendPoint> healthy_points() const;
  [[nodiscard]] double healthy_s() const { return healthy_s_; }
  /// Returns the end of the last window.
  [[nodiscard]] double end_s() const { return last_end_s_; }
  [[nodiscard]] std::size_t windows() const { return windows_; }
  [[nodiscard]] std::size_t alarms() const { return alarms_; }

 private:
  void learn(const TimedWindow& window, bool silent);
  void judge(const TimedWindow& window, bool silent, const Report& report);
  /// Adds a window's rises to the next point. Returns the excess of the feature that exceeds its
  /// limit most.
  double exceed(const Features& features);
  void remember_cause(Eigen::Index feature, double excess_db);
  [[nodiscard]] std::string cause() const;
  void tell(double end_s, const Report& report);

  FeatureMeter meter_;
  std::vector<std::string> names_;
  TrendOptions options_;
  double healthy_s_ = 0;
  double every_s_;
  std::vector<Features> learned_;
  std::vector<double> learned_s_;  ///< ends of the learned windows
  std::optional<Healthy> healthy_;
  TrendAlarm alarm_;
  /// Sums of positive excesses of each feature and, last, of windows without a signal, since the
  /// evidence was 0.
  Eigen::ArrayXd causes_;

  // Since the last point:
  std::size_t since_ = 0;
  std::size_t since_moving_ = 0;  ///< windows that were not constant
  TrendPoint::Rises sums_;
  double last_start_s_ = 0;
  double last_end_s_ = 0;
  double next_s_ = 0;
  bool started_ = false;
  std::size_t windows_ = 0;
  std::size_t alarms_ = 0;
};

}  // namespace piae::trend
