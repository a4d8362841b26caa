#include "monitor/speed_watch.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "spectra/shown_speed.hpp"

namespace piae::monitor {

namespace {

constexpr double block_s = 10;
constexpr double block_turns = 100;
constexpr double most_samples = 1 << 19;  // that an estimate uses
constexpr double agree_within = 0.005;
constexpr double report_beyond = 0.01;
constexpr std::size_t blocks_without_use = 6;

std::size_t block_of(double rate_hz, double given_rpm) {
  if (given_rpm <= 0) return 0;
  const double length_s = std::max(block_s, block_turns * 60 / given_rpm);
  return static_cast<std::size_t>(std::clamp(length_s * rate_hz, 1.0, most_samples));
}

double distance(double rpm, double other_rpm) { return std::abs(rpm / other_rpm - 1); }

}  // namespace

SpeedWatch::SpeedWatch(double rate_hz, SpeedSearch search, std::string stream)
    : rate_hz_(rate_hz),
      search_(std::move(search)),
      stream_(std::move(stream)),
      block_(block_of(rate_hz, search_.given_rpm)),
      reported_rpm_(search_.given_rpm),
      shown_{{-std::numeric_limits<double>::infinity(), search_.given_rpm}} {}

void SpeedWatch::add(std::span<const double> samples) {
  while (!samples.empty() && block_ > 0) {
    const auto some = samples.first(std::min(samples.size(), block_ - samples_.size()));
    samples_.insert(samples_.end(), some.begin(), some.end());
    samples = samples.subspan(some.size());
    if (samples_.size() == block_) finish_block();
  }
}

void SpeedWatch::restart(double next_s) {
  samples_.clear();
  start_s_ = next_s;
}

void SpeedWatch::finish_block() {
  auto shaft = spectra::estimate_shaft_speed(samples_, rate_hz_, search_.given_rpm);
  if (shaft && !shaft->is_certain()) shaft.reset();
  restart(start_s_ + static_cast<double>(block_) / rate_hz_);
  if (shaft && before_ && distance(shaft->rpm, before_->rpm) <= agree_within) take(shaft->rpm);
  before_ = shaft;
  ++blocks_;
  if (search_.percent > 0 || blocks_ < blocks_without_use) return;
  block_ = 0;
  samples_ = {};
}

void SpeedWatch::take(double rpm) {
  const bool is_used = distance(rpm, search_.given_rpm) <= search_.percent / 100 &&
                       (!search_.fits || search_.fits(rpm));
  if (is_used) shown_.push_back({start_s_, rpm});
  report(rpm, is_used);
}

void SpeedWatch::report(double rpm, bool is_used) {
  if (!search_.say || distance(rpm, reported_rpm_) <= report_beyond) return;
  reported_rpm_ = rpm;
  const spectra::ShaftSpeed certain{.rpm = rpm,
                                    .confidence = std::numeric_limits<double>::infinity()};
  const std::string other = spectra::other_speed(certain, search_.given_rpm);
  if (other.empty()) return;
  const std::string use =
      is_used ? fmt::format("this speed is used from {:.0f} s on", start_s_)
              : (search_.percent > 0 ? "the given speed is used"
                                     : "--speed-search-percent takes the speed from the signal");
  search_.say(fmt::format("{}: {} {:g} rpm; {}", stream_, other, search_.given_rpm, use));
}

double SpeedWatch::rpm_at(double end_s) {
  while (shown_.size() > 1 && shown_[1].from_s <= end_s) shown_.erase(shown_.begin());
  return shown_.front().rpm;
}

}  // namespace piae::monitor
