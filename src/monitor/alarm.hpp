#pragma once

#include <cstdint>

#include "cli/options.hpp"

namespace piae::monitor {

/// What is promised of the alarm, and of which machines.
struct AlarmOptions {
  /// Of the windows of a healthy machine, at most this share looks faulty, on average and at any
  /// time: what a classifier does wrong on machines, loads and days that it was not trained on.
  double healthy_share = 0.1;
  /// Of those of a machine with a defect, at least this share does.
  double faulty_share = 0.5;
  /// Of healthy running, from one false alarm to the next, and of a defect, from one false
  /// all-clear to the next: the mean is at least this. Ten times the one in 24 h that may be, so
  /// that in a day there is one with a probability of at most 10 %.
  double hours_per_false_alarm = 240;
};

void bind(const cli::Options& command, AlarmOptions& options);

enum class AlarmState { off, raised, on, cleared };
/// "off", "raised", "on", "cleared".
const char* to_string(AlarmState state);

/// Page's CUSUM test of a share (Page 1954; Reynolds and Stoumbos 1999 for a Bernoulli variable). A
/// window that looks faulty with probability x adds
///     x log(p1 / p0) + (1 - x) log((1 - p1) / (1 - p0))
/// to the evidence, where p0 is healthy_share and p1 faulty_share. It never falls below 0 nor rises
/// above a threshold h. There the alarm is raised; it is cleared when the evidence has fallen to 0
/// again. Between the two it stays as it is, so that no noise about one threshold can make it
/// flutter.
///
/// While x is at most p0 on average, whatever it was until then, exp(evidence since any moment) is
/// a supermartingale, since exp is convex. So after any moment the evidence gained reaches h with a
/// probability of at most exp(-h) (Ville), of n windows one raises a false alarm with a probability
/// of at most n exp(-h), and with h = log(n) the mean from one to the next is at least n windows
/// (Lorden 1971). Windows need not be independent. The same holds for the all-clear, with p1 and
/// the evidence counted from h downwards. A defect is noticed after h / D(x || p0, p1) windows on
/// average, where D is what a window adds.
class Alarm {
 public:
  /// Throws Error(usage) where healthy_share is not below faulty_share.
  Alarm(const AlarmOptions& options, double windows_per_hour);

  /// Of the next window: from 0, surely healthy, to 1.
  AlarmState add(double looks_faulty);

  [[nodiscard]] AlarmState state() const { return state_; }
  /// As a share of the threshold.
  [[nodiscard]] double evidence() const { return evidence_ / threshold_; }
  [[nodiscard]] double threshold() const { return threshold_; }
  /// Windows to the alarm where this share of them looks faulty; infinite where that is too little.
  [[nodiscard]] double windows_to_alarm(double share) const;

 private:
  double of_faulty_;   ///< what a window that looks faulty adds
  double of_healthy_;  ///< what one that does not adds; negative
  double threshold_;
  double evidence_ = 0;
  AlarmState state_ = AlarmState::off;
};

}  // namespace piae::monitor
