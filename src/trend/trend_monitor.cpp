#include "trend/trend_monitor.hpp"

#include <utility>

namespace piae::trend {

TrendMonitor::TrendMonitor(Trend& trend, monitor::SampleFormat format, const std::string& stream,
                           Trend::Report report, monitor::SpeedSearch search)
    : trend_(trend),
      names_(trend.meter().names()),
      feed_(format, stream, trend.meter().rate_hz()),
      cutter_(trend.meter().length(), trend.meter().length()),
      report_(std::move(report)),
      speed_(trend.meter().rate_hz(), std::move(search), stream) {}

Trend::Report TrendMonitor::reporting(const WriteLine& write) const {
  return [this, &write](const TrendPoint& point) {
    write(json_line(point, names_));
    report_(point);
  };
}

void TrendMonitor::judge(std::span<const double> samples, const WriteLine& write) {
  speed_.add(samples);
  cutter_.add(samples);
  const Trend::Report report = reporting(write);
  while (const auto window = cutter_.next()) {
    TimedWindow timed{
        .start_s = started_at_s_ + static_cast<double>(window->first_sample) / feed_.rate_hz(),
        .samples = window->samples};
    if (trend_.meter().lines()) {
      timed.speed_rpm = speed_.rpm_at(timed.start_s + trend_.meter().window_s());
    }
    trend_.add(timed, report);
  }
}

void TrendMonitor::take(std::span<const std::byte> bytes, const WriteLine& write) {
  feed_.add(
      bytes, [&](std::span<const double> samples) { judge(samples, write); }, [&] { restart(); });
}

void TrendMonitor::skip() {
  feed_.restart();
  restart();
}

void TrendMonitor::restart() {
  cutter_.restart();
  started_at_s_ = feed_.signal_s();
  speed_.restart(started_at_s_);
}

void TrendMonitor::end(const WriteLine& write) {
  feed_.finish([&](std::span<const double> samples) { judge(samples, write); }, [&] { restart(); });
  trend_.finish(reporting(write));
}

}  // namespace piae::trend
