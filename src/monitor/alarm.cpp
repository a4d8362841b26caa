#include "monitor/alarm.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.hpp"
#include "base/range.hpp"

namespace piae::monitor {

void bind(const cli::Options& command, AlarmOptions& options) {
  constexpr Range share{.low = 1e-6, .high = 1 - 1e-6};
  constexpr Range hours{.low = 0.01, .high = 1e6, .unit = " h"};
  command
      .add("--healthy-share", options.healthy_share,
           "largest share of a healthy machine's windows that look faulty")
      .check(cli::within(share));
  command
      .add("--faulty-share", options.faulty_share,
           "smallest share of a faulty machine's windows that look faulty; the alarm sums the "
           "logarithmic likelihood ratio of the two shares (CUSUM: Page 1954)")
      .check(cli::within(share));
  command
      .add("--hours-per-false-alarm", options.hours_per_false_alarm,
           "smallest mean time between false alarms, and between false all-clears, h; the "
           "threshold is the logarithm of the number of windows in it (Lorden 1971)")
      .check(cli::within(hours));
}

const char* to_string(AlarmState state) {
  switch (state) {
    case AlarmState::off:
      return "off";
    case AlarmState::raised:
      return "raised";
    case AlarmState::on:
      return "on";
    case AlarmState::cleared:
      return "cleared";
  }
  throw std::logic_error("no such state");
}

Alarm::Alarm(const AlarmOptions& options, double windows_per_hour)
    : of_faulty_(std::log(options.faulty_share / options.healthy_share)),
      of_healthy_(std::log((1 - options.faulty_share) / (1 - options.healthy_share))),
      threshold_(std::log(std::max(2.0, options.hours_per_false_alarm * windows_per_hour))) {
  if (options.healthy_share >= options.faulty_share) {
    throw Error(Exit::usage, fmt::format("--healthy-share {:g} must be below --faulty-share {:g}: "
                                         "more windows of a faulty machine look faulty",
                                         options.healthy_share, options.faulty_share));
  }
}

AlarmState Alarm::add(double looks_faulty) {
  const double gain = looks_faulty * of_faulty_ + (1 - looks_faulty) * of_healthy_;
  evidence_ = std::clamp(evidence_ + gain, 0.0, threshold_);
  const bool is_on = state_ == AlarmState::raised || state_ == AlarmState::on;
  if (is_on) {
    state_ = evidence_ <= 0 ? AlarmState::cleared : AlarmState::on;
  } else {
    state_ = evidence_ >= threshold_ ? AlarmState::raised : AlarmState::off;
  }
  return state_;
}

double Alarm::windows_to_alarm(double share) const {
  const double gain = share * of_faulty_ + (1 - share) * of_healthy_;
  return gain > 0 ? threshold_ / gain : std::numeric_limits<double>::infinity();
}

}  // namespace piae::monitor
