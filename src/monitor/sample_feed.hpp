#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "monitor/samples.hpp"

namespace piae::monitor {

/// Decodes the bytes of a stream and separates its samples from gaps. Samples that are not finite
/// or exceed 1e36, and lines of text that are not a number, are a gap.
class SampleFeed {
 public:
  /// `stream` is the name in messages.
  SampleFeed(SampleFormat format, const std::string& stream, double rate_hz)
      : rate_hz_(rate_hz), decoder_(format, stream, rate_hz) {}

  using Take = std::function<void(std::span<const double>)>;
  using Gap = std::function<void()>;

  /// Passes the samples of the next bytes to `take`, and calls `gap` after each gap: the next
  /// samples do not continue the previous ones. Throws like SampleDecoder::add.
  void add(std::span<const std::byte> bytes, const Take& take, const Gap& gap);
  /// Does the same for the rest at the end of the stream.
  void finish(const Take& take, const Gap& gap);
  /// Drops an incomplete sample, because the next bytes do not continue it.
  void restart() { decoder_.restart(); }

  [[nodiscard]] double rate_hz() const { return rate_hz_; }
  /// Returns the number of samples so far, with gaps.
  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  [[nodiscard]] double signal_s() const { return static_cast<double>(samples_) / rate_hz_; }
  /// Returns the number of samples that are a gap, without lines of text that are not a number.
  [[nodiscard]] std::uint64_t samples_not_finite() const {
    return not_finite_ - decoder_.text().garbled();
  }
  [[nodiscard]] const SampleDecoder& decoder() const { return decoder_; }

 private:
  void pass_on(std::span<const double> samples, const Take& take, const Gap& gap);

  double rate_hz_;
  SampleDecoder decoder_;
  std::uint64_t samples_ = 0;
  std::uint64_t not_finite_ = 0;
  std::vector<double> decoded_;
};

}  // namespace piae::monitor
