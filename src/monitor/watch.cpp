#include "monitor/watch.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "base/range.hpp"
#include "monitor/sample_clock.hpp"

namespace piae::monitor {

namespace {

/// Capacity of a pipe.
constexpr std::size_t bytes_at_once = 1 << 16;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Checks that samples arrive on time.
class Punctuality {
 public:
  Punctuality(double rate_hz, const WatchOptions& options)
      : options_(options), clock_(rate_hz, options.late_s) {}

  void samples_came(std::uint64_t all, double signal_s) {
    if (!options_.realtime) return;
    last_s_ = now_s();
    reported_silence_ = false;
    const double late_s = clock_.late_by(*last_s_, all);
    if (late_s > 0)
      spdlog::warn("after {:.1f} s of signal, the samples are {:.1f} s late", signal_s, late_s);
  }

  void nothing_came(double signal_s) {
    if (!last_s_ || reported_silence_ || now_s() - *last_s_ <= options_.late_s) return;
    reported_silence_ = true;
    spdlog::warn("after {:.1f} s of signal, no samples arrive", signal_s);
  }

  /// Returns "" without --realtime.
  [[nodiscard]] std::string summary() const {
    if (!options_.realtime) return "";
    if (clock_.times() == 0) return "; none was late";
    return fmt::format("; late {} times, by {:.1f} s in all", clock_.times(), clock_.all_s());
  }

 private:
  WatchOptions options_;
  SampleClock clock_;
  std::optional<double> last_s_;
  bool reported_silence_ = false;
};

std::string counted(std::uint64_t n, const std::string& one) {
  return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s");
}

/// Returns "; is it --format f32be?" if the samples look like another format.
std::string other_format(const StreamMonitor& monitor) {
  const std::string likelier = monitor.feed().decoder().likelier_format();
  return likelier.empty() ? "" : fmt::format("; is it --format {}?", likelier);
}

/// Returns the counts of lost samples. Bytes that a WAV header promises count only if the stream
/// has `ended`.
std::string lost(const StreamMonitor& monitor, std::size_t breaks, bool ended) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  const SampleDecoder& decoder = monitor.feed().decoder();
  if (breaks > 0) add("the file restarted " + counted(breaks, "time"));
  if (monitor.feed().samples_not_finite() > 0) {
    add(counted(monitor.feed().samples_not_finite(), "sample") + " not finite or beyond 1e36");
  }
  if (decoder.text().garbled() > 0) {
    add(counted(decoder.text().garbled(), "line") + " not a number");
  }
  if (decoder.waiting() > 0) add(counted(decoder.waiting(), "byte") + " of an unfinished sample");
  if (ended && decoder.wav().missing() > 0) {
    add(counted(decoder.wav().missing(), "byte") + " fewer than the WAV header declares");
  }
  return (text.empty() ? "nothing lost" : "lost: " + text) + other_format(monitor);
}

/// Reports the first gap of each kind at once, because a stream may last for days.
class Gaps {
 public:
  explicit Gaps(const StreamMonitor& monitor) : monitor_(&monitor) {}

  void samples_came() {
    constexpr double windows_to_wait = 10;
    const bool has_windows = monitor_->windows() > 0;
    const bool has_waited = monitor_->feed().signal_s() > windows_to_wait * monitor_->window_s();
    if (!has_windows && !has_waited) return;
    const TextSamples& text = monitor_->feed().decoder().text();
    if (text.garbled() > 0 && !std::exchange(reported_lines_, true)) {
      spdlog::warn("{}; such lines are gaps", text.first_garbled());
    }
    if (has_windows && !std::exchange(reported_format_, true)) {
      const std::string other = other_format(*monitor_);
      if (!other.empty()) spdlog::warn("the samples have unusual magnitudes{}", other);
    }
    if (has_windows || monitor_->feed().samples_not_finite() == 0) return;
    if (!std::exchange(reported_samples_, true)) {
      spdlog::warn("after {:.1f} s of signal, non-finite samples broke every window{}",
                   monitor_->feed().signal_s(), other_format(*monitor_));
    }
  }

 private:
  const StreamMonitor* monitor_;
  bool reported_lines_ = false;
  bool reported_format_ = false;
  bool reported_samples_ = false;
};

std::string summary_of(const StreamMonitor& monitor, const std::string& until) {
  return fmt::format("{} in {:.1f} s of signal until {}: {}; ",
                     counted(monitor.windows(), "window"), monitor.feed().signal_s(), until,
                     counted(monitor.alarms(), "alarm"));
}

void require_windows(const StreamMonitor& monitor, const Input& input) {
  if (monitor.windows() > 0) return;
  const TextSamples& text = monitor.feed().decoder().text();
  if (text.garbled() > 0) throw Error(Exit::bad_input, text.first_garbled());
  if (monitor.feed().samples_not_finite() > 0) {
    const std::string other = other_format(monitor);
    throw Error(Exit::bad_input,
                fmt::format("{}: non-finite samples broke every window ({} of {}){}", input.name(),
                            monitor.feed().samples_not_finite(),
                            counted(monitor.feed().samples(), "sample"),
                            other.empty() ? "; is --format right?" : other));
  }
  throw Error(Exit::bad_input,
              fmt::format("{}: ended after {}, {:.3g} s; a window takes {:.3g} s", input.name(),
                          counted(monitor.feed().samples(), "sample"), monitor.feed().signal_s(),
                          monitor.window_s()));
}

}  // namespace

void bind(const cli::Options& command, WatchOptions& options) {
  constexpr Range late_s{.low = 0.01, .high = 1e6, .unit = " s"};
  command.flag("--realtime", options.realtime,
               "compare the samples with the clock, and warn if they are late");
  command.add("--late-s", options.late_s, "with --realtime: largest delay without a warning, s")
      .check(cli::within(late_s));
}

std::string watch(Input& input, StreamMonitor& monitor, const WatchOptions& options,
                  const std::function<bool()>& stopped,
                  const std::function<void(const std::string&)>& write) {
  std::vector<std::byte> buffer(bytes_at_once);
  std::string lines;
  const auto add_line = [&](const std::string& line) { lines += line; };
  const auto write_lines = [&] {
    if (!lines.empty()) write(lines);
    lines.clear();
  };
  Punctuality punctuality(monitor.feed().rate_hz(), options);
  Gaps gaps(monitor);
  std::size_t breaks = 0;
  bool ended = false;
  while (!ended && !stopped()) {
    const Input::Piece piece = input.read(buffer);
    switch (piece.event) {
      case Input::Event::bytes:
        monitor.take(piece.bytes, add_line);
        punctuality.samples_came(monitor.feed().samples(), monitor.feed().signal_s());
        gaps.samples_came();
        break;
      case Input::Event::none:
        punctuality.nothing_came(monitor.feed().signal_s());
        break;
      case Input::Event::broken:
        ++breaks;
        spdlog::warn(
            "{}: was truncated or replaced after {:.1f} s of signal, and is read from its start; "
            "samples may be lost",
            one_line(input.name()), monitor.feed().signal_s());
        monitor.skip();
        break;
      case Input::Event::end:
        ended = true;
        break;
    }
    write_lines();
  }
  monitor.end(add_line);
  write_lines();
  if (ended) require_windows(monitor, input);
  return summary_of(monitor, ended ? "its end" : "it was stopped") + lost(monitor, breaks, ended) +
         punctuality.summary();
}

}  // namespace piae::monitor
