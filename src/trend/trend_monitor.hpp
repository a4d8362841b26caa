#pragma once

#include <functional>
#include <span>
#include <string>

#include "monitor/sample_feed.hpp"
#include "monitor/speed_watch.hpp"
#include "monitor/stream_monitor.hpp"
#include "monitor/window_cutter.hpp"
#include "trend/trend.hpp"

namespace piae::trend {

/// Passes the windows of a stream to a trend, side by side. No window spans a gap.
class TrendMonitor final : public monitor::StreamMonitor {
 public:
  /// Keeps a reference to the trend. `stream` is the name in messages; `report` receives each
  /// point, in addition to the lines of JSON. Lines lie at the speed that `search` finds.
  TrendMonitor(Trend& trend, monitor::SampleFormat format, const std::string& stream,
               Trend::Report report, monitor::SpeedSearch search);

  void take(std::span<const std::byte> bytes, const WriteLine& write) override;
  void skip() override;
  void end(const WriteLine& write) override;
  [[nodiscard]] const monitor::SampleFeed& feed() const override { return feed_; }
  [[nodiscard]] std::size_t windows() const override { return trend_.windows(); }
  [[nodiscard]] std::size_t alarms() const override { return trend_.alarms(); }
  [[nodiscard]] double window_s() const override { return trend_.meter().window_s(); }

 private:
  void judge(std::span<const double> samples, const WriteLine& write);
  void restart();
  [[nodiscard]] Trend::Report reporting(const WriteLine& write) const;

  Trend& trend_;
  std::vector<std::string> names_;
  monitor::SampleFeed feed_;
  monitor::WindowCutter cutter_;
  Trend::Report report_;
  monitor::SpeedWatch speed_;
  double started_at_s_ = 0;  ///< stream time of the cutter's sample 0
};

}  // namespace piae::trend
