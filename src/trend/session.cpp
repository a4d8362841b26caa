#include "trend/session.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "trend/picture.hpp"
#include "trend/snapshots.hpp"

namespace piae::trend {

Trend::Report Session::remember() {
  return [this](const TrendPoint& point) {
    history_.add(point);
    if (point.alarm == monitor::AlarmState::raised && !first_alarm_) first_alarm_ = point;
  };
}

void Session::watch_record(const std::function<void(const std::string&)>& write) {
  const Trend::Report report = [&, remember = remember()](const TrendPoint& point) {
    write(json_line(point, names_));
    remember(point);
  };
  const FeatureMeter& meter = trend_.meter();
  for_each_window(record_, meter.rate_hz(), meter.length(),
                  [&](const TimedWindow& window) { trend_.add(window, report); });
  trend_.finish(report);
}

void Session::require_baseline() const {
  if (trend_.healthy()) return;
  throw Error(
      Exit::bad_input,
      fmt::format("{}: ends after {:.3g} h, within its first {:g} h, the healthy ones; give "
                  "fewer hours (--healthy)",
                  machine_, trend_.end_s() / 3600, trend_.healthy_s() / 3600));
}

std::string Session::picture() const {
  History healthy;
  for (const TrendPoint& point : trend_.healthy_points()) healthy.add(point);
  const Eigen::ArrayXd& limits = trend_.healthy()->limits_db();
  return picture_of({.machine = machine_,
                     .names = names_,
                     .limits_db = {limits.begin(), limits.end()},
                     .healthy = healthy.points(),
                     .points = history_.points()});
}

void Session::write_baseline(artefact::Writer& writer) const {
  write(writer, trend_.meter(), trend_.healthy()->windows());
}

std::string Session::summary() const {
  return fmt::format("{}: {} windows until {:.3g} h: {} alarm{}", machine_, trend_.windows(),
                     trend_.end_s() / 3600, trend_.alarms(), trend_.alarms() == 1 ? "" : "s");
}

std::string Session::first_alarm() const {
  if (!first_alarm_) return "";
  return fmt::format("; first alarm at {:.4g} h, cause: {}", first_alarm_->time_s / 3600,
                     first_alarm_->cause);
}

}  // namespace piae::trend
