#include "monitor/watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "monitor/judged.hpp"
#include "monitor/monitor.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::monitor {
namespace {

/// Every window is healthy.
diagnosis::Predictions all_healthy(const signal::WindowSet& windows) {
  diagnosis::Predictions predictions;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    predictions.labels.push_back(0);
    predictions.probabilities.insert(predictions.probabilities.end(), {1, 0, 0});
    predictions.novelty.push_back(0);
  }
  return predictions;
}

struct Watched {
  std::string lines;
  std::string summary;
};

/// Watches these bytes at 1000 Hz, in windows of 100 samples.
Watched watched_bytes(const std::string& bytes, SampleFormat format = SampleFormat::f32,
                      const WatchOptions& options = {}, bool stopped = false) {
  const Folder folder;
  Input input(folder.write("raw.f32", bytes), false);
  MonitorOptions of_stream;
  of_stream.sample_rate_hz = 1000;
  of_stream.speed_rpm = 1500;
  of_stream.format = format;
  Monitor monitor(rig(), 100, all_healthy, of_stream, "raw.f32");
  Watched watched;
  watched.summary = watch(
      input, monitor, options, [=] { return stopped; },
      [&](const std::string& text) { watched.lines += text; });
  return watched;
}

std::string bytes_of_floats(const std::vector<float>& samples) {
  return {reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(float)};
}

Watched watched(const std::vector<float>& samples, std::size_t more_bytes = 0,
                const WatchOptions& options = {}, bool stopped = false) {
  return watched_bytes(bytes_of_floats(samples) + std::string(more_bytes, '\0'), SampleFormat::f32,
                       options, stopped);
}

std::vector<float> ramp(std::size_t samples) {
  std::vector<float> ramp(samples);
  for (std::size_t i = 0; i < samples; ++i) ramp[i] = static_cast<float>(i);
  return ramp;
}

TEST(Watch, WritesALinePerSecondAndASummary) {
  const Watched all = watched(ramp(2550));
  EXPECT_EQ(std::ranges::count(all.lines, '\n'), 3);
  EXPECT_TRUE(all.lines.starts_with("{\"time_s\": 1.000, \"windows\": 10,")) << all.lines;
  EXPECT_NE(all.lines.find("\n{\"time_s\": 2.500, \"windows\": 5,"), std::string::npos);
  EXPECT_EQ(all.summary, "25 windows in 2.5 s of signal until its end: 0 alarms; nothing lost");
}

TEST(Watch, ReportsLostSamples) {
  std::vector<float> samples = ramp(250);
  samples[120] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(watched(samples, 3).summary,
            "2 windows in 0.2 s of signal until its end: 0 alarms; lost: 1 sample not finite or "
            "beyond 1e36, 3 bytes of an unfinished sample");
}

/// Noise of 3 s with swapped bytes: about 1 sample in 30 is not finite or too large.
TEST(Watch, SuggestsTheFormatIfSamplesAreNotFinite) {
  Stream random("other order");
  std::vector<float> samples(3000);
  for (float& x : samples) x = static_cast<float>(random.normal(0, 0.1));
  std::string bytes = bytes_of_floats(samples);
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
  }
  const std::string summary = watched_bytes(bytes).summary;  // about 1 window in 20 has no gap
  EXPECT_TRUE(summary.ends_with(" not finite or beyond 1e36; is it --format f32be?")) << summary;
  EXPECT_EQ(watched_bytes(bytes, SampleFormat::f32be).summary,
            "30 windows in 3.0 s of signal until its end: 0 alarms; nothing lost");
}

TEST(Watch, FailsIfNonFiniteSamplesBreakEveryWindow) {
  std::vector<float> samples = ramp(300);
  for (const std::size_t i : {50, 149, 248}) {
    samples[i] = std::numeric_limits<float>::infinity();
  }
  EXPECT_ERROR(watched(samples), Exit::bad_input,
               "raw.f32: non-finite samples broke every window (3 of 300 samples); is --format "
               "right?");
}

TEST(Watch, CountsInvalidLines) {
  std::string text = "a header\n";
  for (int i = 0; i < 250; ++i) text += i == 120 ? "1.2x\n" : std::to_string(i % 9) + "\n";
  EXPECT_EQ(watched_bytes(text, SampleFormat::text).summary,
            "2 windows in 0.3 s of signal until its end: 0 alarms; lost: 2 lines not a number");
  EXPECT_ERROR(watched_bytes("time,x\n0,1\n", SampleFormat::text), Exit::bad_input,
               "raw.f32, line 1: 'time,x' is not a number");
}

TEST(Watch, CountsBytesMissingFromWav) {
  const std::string header(
      "RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\xE8\x03\0\0\xD0\x07\0\0\x02"
      "\0\x10\0data\x90\x01\0\0",
      44);  // 400 bytes at 1000 Hz
  std::string samples;
  for (int i = 0; i < 150; ++i) samples += std::string{static_cast<char>(i), '\1'};
  EXPECT_EQ(watched_bytes(header + samples, SampleFormat::wav).summary,
            "1 window in 0.1 s of signal until its end: 0 alarms; lost: 100 bytes fewer than the "
            "WAV header declares");
}

TEST(Watch, ReportsThatNothingWasLateIfRequested) {
  EXPECT_EQ(watched(ramp(100), 0, {.realtime = true}).summary,
            "1 window in 0.1 s of signal until its end: 0 alarms; nothing lost; none was late");
}

TEST(Watch, StopsOnRequest) {
  const Watched none = watched(ramp(2550), 0, {}, true);
  EXPECT_EQ(none.lines, "");
  EXPECT_EQ(none.summary,
            "0 windows in 0.0 s of signal until it was stopped: 0 alarms; nothing lost");
}

TEST(Watch, FailsIfTheStreamIsShorterThanAWindow) {
  EXPECT_ERROR(watched(ramp(99)), Exit::bad_input,
               "raw.f32: ended after 99 samples, 0.099 s; a window takes 0.1 s");
}

}  // namespace
}  // namespace piae::monitor
