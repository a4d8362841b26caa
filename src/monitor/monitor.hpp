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
#include "monitor/window_cutter.hpp"
#include "signal/resample.hpp"

namespace piae::monitor {

struct MonitorOptions {
  double sample_rate_hz = 0;  ///< of the stream; must be given
  double speed_rpm = 0;       ///< of the shaft; must be given
  SampleFormat format = SampleFormat::f32;
  std::size_t stride = 0;  ///< samples between the starts of two windows; 0: their length
  double every_s = 1;      ///< of the stream, between two decisions; 0: one for each window
  AlarmOptions alarm;
};

void bind(const cli::Options& command, MonitorOptions& options);

/// A stream of raw samples, judged window by window as it comes. It keeps what the next window
/// needs and nothing else, and says the same however the stream was cut into pieces.
class Monitor {
 public:
  /// `info` and `length` (samples in a window) are the classifier's, whose answers `answer` gives;
  /// `stream` is what messages call the stream.
  Monitor(const signal::DatasetInfo& info, std::size_t length, Answer answer,
          const MonitorOptions& options, const std::string& stream);

  using Say = std::function<void(const Decision&)>;

  /// The bytes that come next. Samples that are not finite, or beyond 1e36, and lines of text that
  /// are not a number are a gap: no window spans it. Throws as SampleDecoder::add.
  void add(std::span<const std::byte> bytes, const Say& say);
  /// What comes next does not follow what came before.
  void skip();
  /// No more will come.
  void finish(const Say& say);

  [[nodiscard]] const Judge& judge() const { return judge_; }
  /// Of the stream, at its own rate.
  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  [[nodiscard]] double signal_s() const;
  [[nodiscard]] double rate_hz() const { return rate_hz_; }
  [[nodiscard]] double window_s() const;
  /// Counts samples that are a gap, without lines of text that are not a number.
  [[nodiscard]] std::uint64_t samples_not_finite() const {
    return not_finite_ - decoder_.text().garbled();
  }
  [[nodiscard]] const SampleDecoder& decoder() const { return decoder_; }

 private:
  void take(std::span<const double> samples, const Say& say);
  void begin_anew();
  /// A window that was cut. One in which nothing moves is not shown to the classifier.
  struct Cut {
    double end_s = 0;
    bool silent = false;
  };
  void judge_windows(const Say& say);
  void judge_cuts(const std::vector<Cut>& cuts, const diagnosis::Answers& answers, const Say& say);

  signal::DatasetInfo info_;
  std::size_t length_;
  Answer answer_;
  double rate_hz_;
  double speed_rpm_;
  SampleDecoder decoder_;
  signal::StreamResampler resampler_;
  WindowCutter cutter_;
  Judge judge_;

  double begun_at_s_ = 0;  ///< when what the cutter counts its samples from came
  std::uint64_t samples_ = 0;
  std::uint64_t not_finite_ = 0;
  std::vector<double> decoded_;
  std::vector<double> resampled_;
};

}  // namespace piae::monitor
