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
  double sample_rate_hz = 0;  ///< required; rate of the stream
  double speed_rpm = 0;       ///< required; speed of the shaft
  SampleFormat format = SampleFormat::f32;
  std::size_t stride = 0;  ///< samples between the starts of two windows; 0: their length
  double every_s = 1;      ///< seconds of the stream between two decisions; 0: one for each window
  AlarmOptions alarm;
};

void bind(const cli::Options& command, MonitorOptions& options);

/// Judges a stream of raw samples window by window, as the samples arrive. Keeps only the samples
/// that the next window needs. The decisions do not depend on how the stream was cut into pieces.
class Monitor {
 public:
  /// Takes the classifier's `info` and `length` (samples in a window); `predict` returns its
  /// predictions. `stream` is the name in messages.
  Monitor(const signal::DatasetInfo& info, std::size_t length, Predict predict,
          const MonitorOptions& options, const std::string& stream);

  using Report = std::function<void(const Decision&)>;

  /// Adds the next bytes. Samples that are not finite or exceed 1e36, and lines of text that are
  /// not a number, are a gap: no window spans a gap. Throws like SampleDecoder::add.
  void add(std::span<const std::byte> bytes, const Report& report);
  /// Marks a break: the next bytes do not continue the previous ones.
  void skip();
  /// Judges the rest at the end of the stream.
  void finish(const Report& report);

  [[nodiscard]] const Judge& judge() const { return judge_; }
  /// Returns the number of samples so far, at the stream's own rate.
  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  [[nodiscard]] double signal_s() const;
  [[nodiscard]] double rate_hz() const { return rate_hz_; }
  [[nodiscard]] double window_s() const;
  /// Returns the number of samples that are a gap, without lines of text that are not a number.
  [[nodiscard]] std::uint64_t samples_not_finite() const {
    return not_finite_ - decoder_.text().garbled();
  }
  [[nodiscard]] const SampleDecoder& decoder() const { return decoder_; }

 private:
  void take(std::span<const double> samples, const Report& report);
  void begin_anew();
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
  double rate_hz_;
  double speed_rpm_;
  SampleDecoder decoder_;
  signal::StreamResampler resampler_;
  WindowCutter cutter_;
  Judge judge_;

  double started_at_s_ = 0;  ///< stream time of the cutter's sample 0
  std::uint64_t samples_ = 0;
  std::uint64_t not_finite_ = 0;
  std::vector<double> decoded_;
  std::vector<double> resampled_;
};

}  // namespace piae::monitor
