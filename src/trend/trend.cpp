#include "trend/trend.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signal/amplitude.hpp"

namespace piae::trend {

namespace {

using monitor::AlarmState;

constexpr double seconds_per_hour = 3600;
constexpr double without_signal_db = 1e6;  // a window adds half the threshold at most

}  // namespace

Trend::Trend(FeatureMeter meter, const TrendOptions& options, double healthy_h, double every_s)
    : meter_(std::move(meter)),
      names_(meter_.names()),
      options_(options),
      healthy_s_(healthy_h * seconds_per_hour),
      every_s_(every_s),
      alarm_(options.alarm_db_h),
      causes_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(names_.size() + 1))),
      next_s_(every_s) {}

Trend::Trend(Baseline baseline, const TrendOptions& options, double every_s)
    : Trend(std::move(baseline.meter), options, 0, every_s) {
  healthy_.emplace(std::move(baseline.windows), options_);
}

void Trend::add(const TimedWindow& window, const Report& report) {
  const bool silent = signal::is_constant(window.samples);
  ++windows_;
  if (!healthy_ && window.start_s < healthy_s_) {
    learn(window, silent);
  } else {
    if (!healthy_) healthy_.emplace(std::move(learned_), options_);
    judge(window, silent, report);
  }
  last_start_s_ = window.start_s;
  last_end_s_ = window.start_s + meter_.window_s();
  started_ = true;
}

void Trend::learn(const TimedWindow& window, bool silent) {
  if (silent) return;
  learned_.push_back(meter_.measure(window.samples, window.speed_rpm));
  learned_s_.push_back(window.start_s + meter_.window_s());
}

void Trend::judge(const TimedWindow& window, bool silent, const Report& report) {
  const double passed_s = started_ ? window.start_s - last_start_s_ : meter_.window_s();
  ++since_;
  double excess_db = without_signal_db;
  if (silent) {
    remember_cause(causes_.size() - 1, excess_db);
  } else {
    excess_db = exceed(meter_.measure(window.samples, window.speed_rpm));
  }
  const AlarmState alarm = alarm_.add(excess_db, passed_s / seconds_per_hour);
  alarms_ += alarm == AlarmState::raised ? 1 : 0;
  const double end_s = window.start_s + meter_.window_s();
  const bool changed = alarm == AlarmState::raised || alarm == AlarmState::cleared;
  if (changed || end_s >= next_s_) tell(end_s, report);
  if (alarm_.evidence() <= 0) causes_.setZero();
}

double Trend::exceed(const Features& features) {
  const Eigen::ArrayXd rises_db = healthy_->rises_db(features);
  if (since_moving_++ == 0) {
    sums_ = {.level_db = 0, .watched_db = Eigen::ArrayXd::Zero(rises_db.size()), .novelty = 0};
  }
  sums_.level_db += healthy_->level_rise_db(features);
  sums_.watched_db += rises_db;
  sums_.novelty += healthy_->novelty(features);
  Eigen::Index most = 0;
  const double excess_db = (rises_db - healthy_->limits_db()).maxCoeff(&most);
  remember_cause(most, excess_db);
  return excess_db;
}

void Trend::remember_cause(Eigen::Index feature, double excess_db) {
  causes_[feature] += std::max(excess_db, 0.0);
}

std::string Trend::cause() const {
  if (alarm_.state() != AlarmState::raised && alarm_.state() != AlarmState::on) return {};
  Eigen::Index most = 0;
  causes_.maxCoeff(&most);
  const auto place = static_cast<std::size_t>(most);
  return place < names_.size() ? names_[place] : "no signal";
}

void Trend::tell(double end_s, const Report& report) {
  TrendPoint point{.time_s = end_s,
                   .windows = since_,
                   .evidence = alarm_.evidence(),
                   .alarm = alarm_.state(),
                   .cause = cause()};
  if (since_moving_ > 0) {
    const auto n = static_cast<double>(since_moving_);
    point.rises = {.level_db = sums_.level_db / n,
                   .watched_db = sums_.watched_db / n,
                   .novelty = sums_.novelty / n};
  }
  since_ = 0;
  since_moving_ = 0;
  if (every_s_ > 0) next_s_ = every_s_ * (std::floor(end_s / every_s_) + 1);
  report(point);
}

void Trend::finish(const Report& report) {
  if (!healthy_ && started_ && last_end_s_ >= healthy_s_) {
    healthy_.emplace(std::move(learned_), options_);
  }
  if (since_ > 0) tell(last_end_s_, report);
}

std::vector<TrendPoint> Trend::healthy_points() const {
  std::vector<TrendPoint> points;
  if (!healthy_) return points;
  for (std::size_t i = 0; i < learned_s_.size(); ++i) {
    const Features& window = healthy_->windows()[i];
    points.push_back({.time_s = learned_s_[i],
                      .windows = 1,
                      .rises = TrendPoint::Rises{.level_db = healthy_->level_rise_db(window),
                                                 .watched_db = healthy_->rises_db(window),
                                                 .novelty = healthy_->novelty(window)}});
  }
  return points;
}

}  // namespace piae::trend
