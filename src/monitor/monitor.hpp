#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "monitor/alarm.hpp"
#include "monitor/decision.hpp"
#include "monitor/judge.hpp"
#include "monitor/samples.hpp"
#include "monitor/speed_watch.hpp"
#include "monitor/stream_monitor.hpp"
#include "monitor/window_cutter.hpp"
#include "signal/resample.hpp"

namespace piae::monitor {

struct MonitorOptions {
  double sample_rate_hz = 0;        ///< of the stream; 0: not given
  double speed_rpm = 0;             ///< of the shaft; 0: not given
  double speed_search_percent = 0;  ///< see SpeedSearch
  SampleFormat format = SampleFormat::f32;
  std::size_t stride = 0;  ///< samples between the starts of two windows; 0: their length
  double every_s = 1;      ///< seconds of the stream between two decisions; 0: one for each window
  AlarmOptions alarm;
};

void bind(const cli::Options& command, MonitorOptions& options);

/// Adds the options of a stream to a search; the given speed is `speed_rpm`.
SpeedSearch search_of(const MonitorOptions& options, double speed_rpm, SpeedSearch search = {});

/// Throws Error(usage) if rate or speed is not given.
void require_given(const MonitorOptions& options);

/// Judges a stream of raw samples window by window, as the samples arrive. Keeps only the samples
/// that the next window needs. The decisions do not depend on how the stream was cut into pieces.
class Monitor final : public StreamMonitor {
 public:
  /// Takes the classifier's `info` and `length` (samples in a window); `predict` returns its
  /// predictions. `stream` is the name in messages. `search` has no speeds; these are options.
  Monitor(const signal::DatasetInfo& info, std::size_t length, Predict predict,
          const MonitorOptions& options, const std::string& stream, SpeedSearch search = {});

  using Report = std::function<void(const Decision&)>;

  /// Adds the next bytes. No window spans a gap (sample_feed.hpp). Throws like SampleDecoder::add.
  void add(std::span<const std::byte> bytes, const Report& report);
  /// Judges the rest at the end of the stream.
  void finish(const Report& report);

  void take(std::span<const std::byte> bytes, const WriteLine& write) override;
  void skip() override;
  void end(const WriteLine& write) override;
  [[nodiscard]] const SampleFeed& feed() const override { return feed_; }
  [[nodiscard]] std::size_t windows() const override { return judge_.windows(); }
  [[nodiscard]] std::size_t alarms() const override { return judge_.alarms(); }
  [[nodiscard]] double window_s() const override;

  [[nodiscard]] const Judge& judge() const { return judge_; }

 private:
  void judge_samples(std::span<const double> samples, const Report& report);
  void restart();
  /// A window of the stream. Silent (constant) windows are not passed to the classifier.
  struct Cut {
    double end_s = 0;
    bool silent = false;
  };
  void judge_windows(const Report& report);
  void judge_cuts(const std::vector<Cut>& cuts, const diagnosis::Predictions& predictions,
                  const Report& report);

  signal::DatasetInfo info_;
  std::size_t length_;
  Predict predict_;
  SpeedWatch speed_;
  SampleFeed feed_;
  signal::StreamResampler resampler_;
  WindowCutter cutter_;
  Judge judge_;

  double started_at_s_ = 0;  ///< stream time of the cutter's sample 0
  std::vector<double> resampled_;
};

}  // namespace piae::monitor
