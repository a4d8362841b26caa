#include "monitor/watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "monitor/judged.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::monitor {
namespace {

/// Every window is healthy.
diagnosis::Answers all_healthy(const signal::WindowSet& windows) {
  diagnosis::Answers answers;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    answers.labels.push_back(0);
    answers.probabilities.insert(answers.probabilities.end(), {1, 0, 0});
    answers.strangeness.push_back(0);
  }
  return answers;
}

struct Watched {
  std::string lines;
  std::string summary;
};

/// Windows of 100 of these samples, at 1000 Hz, and so many bytes more.
Watched watched(const std::vector<float>& samples, std::size_t more_bytes = 0,
                const WatchOptions& options = {}, bool stopped = false) {
  const Folder folder;
  std::string bytes(reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(float));
  Input input(folder.write("raw.f32", bytes + std::string(more_bytes, '\0')), false);
  MonitorOptions of_stream;
  of_stream.sample_rate_hz = 1000;
  of_stream.speed_rpm = 1500;
  Monitor monitor(rig(), 100, all_healthy, of_stream, input.name());
  Watched watched;
  watched.summary = watch(
      input, monitor, rig(), options, [=] { return stopped; },
      [&](const std::string& text) { watched.lines += text; });
  return watched;
}

std::vector<float> ramp(std::size_t samples) {
  std::vector<float> ramp(samples);
  for (std::size_t i = 0; i < samples; ++i) ramp[i] = static_cast<float>(i);
  return ramp;
}

TEST(Watch, WritesALineASecondAndSaysHowMuchItHeard) {
  const Watched all = watched(ramp(2550));
  EXPECT_EQ(std::ranges::count(all.lines, '\n'), 3);
  EXPECT_TRUE(all.lines.starts_with("{\"time_s\": 1.000, \"windows\": 10,")) << all.lines;
  EXPECT_NE(all.lines.find("\n{\"time_s\": 2.500, \"windows\": 5,"), std::string::npos);
  EXPECT_EQ(all.summary, "25 windows in 2.5 s of signal until its end: 0 alarms; nothing lost");
}

TEST(Watch, SaysWhatWasLost) {
  std::vector<float> samples = ramp(250);
  samples[120] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(watched(samples, 3).summary,
            "2 windows in 0.2 s of signal until its end: 0 alarms; lost: 1 sample not finite or "
            "beyond 1e36, 3 bytes of an unfinished sample");
}

TEST(Watch, SaysThatNothingWasLateWhereAsked) {
  EXPECT_EQ(watched(ramp(100), 0, {.realtime = true}).summary,
            "1 window in 0.1 s of signal until its end: 0 alarms; nothing lost; none was late");
}

TEST(Watch, StopsWhenItIsTold) {
  const Watched none = watched(ramp(2550), 0, {}, true);
  EXPECT_EQ(none.lines, "");
  EXPECT_EQ(none.summary,
            "0 windows in 0.0 s of signal until it was told to stop: 0 alarms; nothing lost");
}

TEST(Watch, AStreamShorterThanAWindowIsAnError) {
  EXPECT_ERROR(watched(ramp(99)), Exit::bad_input,
               "raw.f32: ended after 99 samples, 0.099 s; a window takes 0.1 s");
}

}  // namespace
}  // namespace piae::monitor
