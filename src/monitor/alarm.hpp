#pragma once

#include <cstdint>

#include "cli/options.hpp"

namespace piae::monitor {

/// Guarantees of the alarm and the machines they hold for.
struct AlarmOptions {
  /// Largest share of a healthy machine's windows that look faulty, on average and at any time.
  /// Covers a classifier's errors on machines, loads and days that it was not trained on.
  double healthy_share = 0.1;
  /// Smallest share of a faulty machine's windows that look faulty.
  double faulty_share = 0.5;
  /// Smallest mean time between false alarms of a healthy machine, and between false all-clears of
  /// a faulty one, in h. The default of ten days limits the probability of a false alarm in a day
  /// to 10 %.
  double hours_per_false_alarm = 240;
};

void bind(const cli::Options& command, AlarmOptions& options);

enum class AlarmState { off, raised, on, cleared };
/// "off", "raised", "on", "cleared".
const char* to_string(AlarmState state);

/// Page's CUSUM test of a share (Page 1954; Reynolds and Stoumbos 1999 for a Bernoulli variable). A
/// window that looks faulty with probability x adds this evidence, with p0 = healthy_share and p1 =
/// faulty_share:
///     x log(p1 / p0) + (1 - x) log((1 - p1) / (1 - p0))
/// The evidence stays between 0 and a threshold h. The alarm is raised at h and cleared when the
/// evidence has returned to 0. The two levels keep noise near one threshold from switching the
/// alarm on and off.
///
/// While x is at most p0 on average, given all earlier windows, exp(evidence since any moment) is a
/// supermartingale, since exp is convex. This has three consequences. After any moment, the
/// evidence gained reaches h with a probability of at most exp(-h) (Ville). Among n windows, a
/// false alarm has a probability of at most n exp(-h). With h = log(n), the mean between false
/// alarms is at least n windows (Lorden 1971). Windows need not be independent. The same holds for
/// the all-clear, with p1 and the evidence counted from h downwards. A defect raises the alarm
/// after h / D(x || p0, p1) windows on average, where D is the evidence that one window adds.
class Alarm {
 public:
  /// Throws Error(usage) unless healthy_share is below faulty_share.
  Alarm(const AlarmOptions& options, double windows_per_hour);

  /// Adds the next window's probability of looking faulty, 0 to 1, and returns the new state.
  AlarmState add(double looks_faulty);

  [[nodiscard]] AlarmState state() const { return state_; }
  /// Returns the evidence as a share of the threshold.
  [[nodiscard]] double evidence() const { return evidence_ / threshold_; }
  [[nodiscard]] double threshold() const { return threshold_; }
  /// Returns the mean number of windows until an alarm if this share looks faulty; infinite if it
  /// is too small.
  [[nodiscard]] double windows_to_alarm(double share) const;

 private:
  double of_faulty_;   ///< evidence that a faulty-looking window adds
  double of_healthy_;  ///< evidence that a healthy-looking window adds; negative
  double threshold_;
  double evidence_ = 0;
  AlarmState state_ = AlarmState::off;
};

}  // namespace piae::monitor
