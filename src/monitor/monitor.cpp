#include "monitor/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/range.hpp"
#include "diagnosis/novelty.hpp"
#include "signal/amplitude.hpp"
#include "signal/ranges.hpp"

namespace piae::monitor {

namespace {

/// Largest number of windows classified at once: enough to be fast, few enough to save memory.
constexpr std::size_t most_at_once = 64;

double windows_per_hour(const signal::DatasetInfo& info, std::size_t stride) {
  return 3600 * info.sample_rate_hz / static_cast<double>(stride);
}

}  // namespace

void bind(const cli::Options& command, MonitorOptions& options) {
  constexpr Range every_s{.low = 0, .high = 1e9, .unit = " s"};
  command.choose("--format", options.format, sample_format_words(),
                 "format of the stream: floats or integers with this number of bits, in the byte "
                 "order of this machine (be: big-endian), without a header; wav with one channel; "
                 "or text, one number per line");
  command.add("--sample-rate-hz", options.sample_rate_hz, "sample rate of the stream, Hz")
      .check(cli::within(signal::ranges::sample_rate_hz));
  command.add("--speed-rpm", options.speed_rpm, "shaft speed, rpm")
      .check(cli::within(signal::ranges::shaft_speed_rpm));
  command
      .add("--speed-search-percent", options.speed_search_percent,
           "take the shaft speed from the signal, within this range about the given speed; where "
           "the shaft hardly shows, and with 0, the given speed counts")
      .check(cli::within(signal::ranges::speed_search_percent));
  command
      .add("--stride", options.stride,
           "distance between window starts, samples at the classifier's rate; 0: the window "
           "length, so that every sample is used once")
      .check(cli::within(signal::ranges::first_sample));
  command
      .add("--every-s", options.every_s,
           "time between decisions, s of the stream; 0: one for each window. An alarm is reported "
           "at once")
      .check(cli::within(every_s));
  bind(command.in_group("Alarm"), options.alarm);
}

void require_given(const MonitorOptions& options) {
  const auto refuse = [](const std::string& option) {
    throw Error(Exit::usage, option + " is required (see monitor --help)");
  };
  if (options.sample_rate_hz <= 0) refuse("--sample-rate-hz");
  if (options.speed_rpm <= 0) refuse("--speed-rpm");
}

SpeedSearch search_of(const MonitorOptions& options, double speed_rpm, SpeedSearch search) {
  search.given_rpm = speed_rpm;
  search.percent = options.speed_search_percent;
  return search;
}

Monitor::Monitor(const signal::DatasetInfo& info, std::size_t length, Predict predict,
                 const MonitorOptions& options, const std::string& stream, SpeedSearch search)
    : info_(info),
      length_(length),
      predict_(std::move(predict)),
      speed_(options.sample_rate_hz, search_of(options, options.speed_rpm, std::move(search)),
             stream),
      feed_(options.format, stream, options.sample_rate_hz),
      resampler_(options.sample_rate_hz, info.sample_rate_hz),
      cutter_(length, options.stride == 0 ? length : options.stride),
      judge_(info,
             Alarm(options.alarm,
                   windows_per_hour(info, options.stride == 0 ? length : options.stride)),
             options.every_s) {}

double Monitor::window_s() const { return static_cast<double>(length_) / info_.sample_rate_hz; }

void Monitor::add(std::span<const std::byte> bytes, const Report& report) {
  feed_.add(
      bytes, [&](std::span<const double> samples) { judge_samples(samples, report); },
      [&] { restart(); });
}

void Monitor::take(std::span<const std::byte> bytes, const WriteLine& write) {
  add(bytes, [&](const Decision& decision) { write(json_line(decision, info_)); });
}

void Monitor::end(const WriteLine& write) {
  finish([&](const Decision& decision) { write(json_line(decision, info_)); });
}

void Monitor::judge_samples(std::span<const double> samples, const Report& report) {
  speed_.add(samples);
  resampled_.clear();
  resampler_.add(samples, resampled_);
  judge_windows(report);
}

void Monitor::skip() {
  feed_.restart();
  restart();
}

void Monitor::restart() {
  resampler_ = signal::StreamResampler(feed_.rate_hz(), info_.sample_rate_hz);
  cutter_.restart();
  started_at_s_ = feed_.signal_s();
  speed_.restart(started_at_s_);
}

void Monitor::finish(const Report& report) {
  feed_.finish([&](std::span<const double> samples) { judge_samples(samples, report); },
               [&] { restart(); });
  resampled_.clear();
  resampler_.finish(resampled_);
  judge_windows(report);
  if (const auto decision = judge_.finish()) report(*decision);
}

/// Judges the windows that the resampled samples complete.
void Monitor::judge_windows(const Report& report) {
  cutter_.add(resampled_);
  for (;;) {
    std::vector<Cut> cuts;
    signal::WindowSet moving;
    moving.info = info_;
    moving.length = length_;
    while (cuts.size() < most_at_once) {
      const auto window = cutter_.next();
      if (!window) break;
      const auto end = static_cast<double>(window->first_sample + length_);
      cuts.push_back(
          {started_at_s_ + end / info_.sample_rate_hz, signal::is_constant(window->samples)});
      if (cuts.back().silent) continue;
      moving.samples.insert(moving.samples.end(), window->samples.begin(), window->samples.end());
      moving.labels.push_back(info_.healthy_label());
      moving.shaft_speed_rpm.push_back(speed_.rpm_at(cuts.back().end_s));
    }
    moving.condition.assign(moving.size(), signal::every_condition);
    if (cuts.empty()) return;
    judge_cuts(cuts, moving.size() > 0 ? predict_(moving) : diagnosis::Predictions{}, report);
  }
}

/// Judges the windows in their order; `predictions` covers those that are not silent.
void Monitor::judge_cuts(const std::vector<Cut>& cuts, const diagnosis::Predictions& predictions,
                         const Report& report) {
  const std::size_t classes = info_.classes.size();
  std::size_t answered = 0;
  for (const Cut& cut : cuts) {
    Judge::Finding finding;
    finding.end_s = cut.end_s;
    if (!cut.silent) {
      finding.classes = std::span(predictions.probabilities).subspan(answered * classes, classes);
      finding.unknown = predictions.novelty[answered] > diagnosis::highest_known_novelty;
      ++answered;
    }
    if (const auto decision = judge_.add(finding)) report(*decision);
  }
}

}  // namespace piae::monitor
