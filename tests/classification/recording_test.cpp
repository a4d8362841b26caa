#include "classification/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/wdcnn_inputs.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/three_classes.hpp"
#include "support/turning_shaft.hpp"

namespace piae::classification {
namespace {

using testing::ElementsAre;

/// Returns a recording with all samples different.
Recording counting_recording(std::size_t samples) {
  Recording recording{.name = "a.csv", .shaft_speed_rpm = 1790, .true_class = "", .signal = {}};
  for (std::size_t i = 0; i < samples; ++i) recording.signal.push_back(static_cast<double>(i));
  return recording;
}

TEST(Windows, StartOneStepApartAndEndWithinTheRecording) {
  const signal::WindowSet windows = windows_of(counting_recording(10), three_classes(), 4, 3);
  EXPECT_EQ(windows.length, 4U);
  EXPECT_THAT(windows.first_sample, ElementsAre(0, 3, 6));
  EXPECT_THAT(windows.samples, ElementsAre(0, 1, 2, 3, 3, 4, 5, 6, 6, 7, 8, 9));
  EXPECT_EQ(windows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(windows.speed_rpm(i), 1790);
  EXPECT_EQ(windows_of(counting_recording(9), three_classes(), 4, 3).size(), 2U);
  EXPECT_EQ(windows_of(counting_recording(4), three_classes(), 4, 4).size(), 1U);
}

TEST(Windows, NeedALongEnoughRecording) {
  EXPECT_ERROR(windows_of(counting_recording(5999), three_classes(), 6000, 6000), Exit::bad_input,
               "a.csv: has 5999 samples at 12000 Hz, but a window of the classifier has 6000; "
               "make a longer recording");
  EXPECT_ERROR(windows_of(counting_recording(1200), three_classes(), 6000, 6000), Exit::bad_input,
               "a.csv: has 1200 samples");
}

TEST(Windows, RefuseADeadChannel) {
  Recording recording = counting_recording(36000);
  std::fill(recording.signal.begin() + 12000, recording.signal.begin() + 24000, 5.0);
  EXPECT_ERROR(windows_of(recording, three_classes(), 6000, 6000), Exit::bad_input,
               "a.csv: is constant from 1 to 1.5 s (a dead channel); cut that stretch out");
}

class LoneFiles : public testing::Test {
 protected:
  [[nodiscard]] Recording read(const std::string& name, const std::string& text,
                               double rate_hz = 12000) const {
    return read_lone_file({.file = folder_.write(name, text),
                           .variable = "1",
                           .sample_rate_hz = rate_hz,
                           .shaft_speed_rpm = 1790},
                          {diagnosis::wdcnn, trained_});
  }
  const signal::DatasetInfo trained_ = three_classes();
  const Folder folder_;
};

TEST_F(LoneFiles, AreReadUnchanged) {
  const Recording recording = read("a.csv", "1\n2.5\n-3\n");
  EXPECT_EQ(recording.name, "a.csv");
  EXPECT_EQ(recording.shaft_speed_rpm, 1790);
  EXPECT_EQ(recording.true_class, "");
  EXPECT_THAT(recording.signal, ElementsAre(1, 2.5, -3));
}

TEST_F(LoneFiles, AreResampledFromAHigherRate) {
  std::string text;
  for (int i = 0; i < 4800; ++i) text += std::to_string(i % 7) + '\n';
  EXPECT_EQ(read("a.csv", text, 48000).signal.size(), 1200U);
}

TEST_F(LoneFiles, AreRefusedIfTheyDoNotFit) {
  EXPECT_ERROR(read("a.csv", "1\n2\n", 8000), Exit::bad_input, "is sampled at 8000 Hz");
}

TEST_F(LoneFiles, NeedFiniteSamples) {
  for (const std::string odd : {"nan", "inf", "1e39"}) {
    EXPECT_ERROR(read("a.csv", "1\n2\n" + odd + "\n4\n"), Exit::bad_input,
                 "a.csv: sample 2 (counted from 0) is NaN, infinite or beyond 32 bits");
  }
}

// The name is shown in tables, pictures and artefacts.
TEST_F(LoneFiles, HaveNamesWithoutTerminalCommands) {
  EXPECT_EQ(read("a\x1B[2J.csv", "1\n2\n").name, "a?[2J.csv");
}

/// The classifier allows 5 % about 1800 rpm.
TEST_F(LoneFiles, HaveTheSpeedOfTheirSignalIfItIsSearched) {
  const LoneFile lone{.file = folder_.write("a.csv", column_of(turning_shaft(1790, 60000, 12000))),
                      .variable = "1",
                      .sample_rate_hz = 12000,
                      .shaft_speed_rpm = 1690};
  EXPECT_ERROR(read_lone_file(lone, {diagnosis::wdcnn, trained_}), Exit::bad_input,
               "was recorded at 1690 rpm");
  const Recording recording = read_lone_file(
      lone, {.classifier = diagnosis::wdcnn, .trained = trained_, .speed_search_percent = 10});
  EXPECT_EQ(recording.given_speed_rpm, 1690);
  EXPECT_NEAR(recording.shaft_speed_rpm, 1790, 2);
  EXPECT_EQ(recording.shaft_speed_rpm, recording.shaft->rpm);
  EXPECT_ERROR(
      read_lone_file(
          lone, {.classifier = diagnosis::wdcnn, .trained = trained_, .speed_search_percent = 3}),
      Exit::bad_input, "was recorded at 1690 rpm");
}

/// Windows of 0.1 s at 12 kHz.
TEST(DescribedRecord, HasTheRecordedSpeedInEachWindow) {
  signal::Record record;
  record.name = "IR-02";
  record.label = 1;
  record.shaft_speed_rpm = 1790;
  record.signal = turning_shaft(1700, 36000, 12000);  // must not count
  record.speeds = signal::SpeedCourse{.block_s = 1, .rpm = {1750, 1790, 1830}};
  const signal::DatasetInfo trained = three_classes();
  const Recording recording = recording_of(
      record, three_classes("other"),
      {.classifier = diagnosis::wdcnn, .trained = trained, .speed_search_percent = 10});
  EXPECT_EQ(recording.shaft, std::nullopt);
  EXPECT_EQ(recording.shaft_speed_rpm, 1790);
  const signal::WindowSet windows = windows_of(recording, trained, 1200, 600);
  ASSERT_EQ(windows.size(), 59U);
  EXPECT_NEAR(windows.speed_rpm(0), 1750, 1e-9);
  EXPECT_NEAR(windows.speed_rpm(19), 1770, 1e-9);  // half before the first second's end
  EXPECT_NEAR(windows.speed_rpm(58), 1830, 1e-9);
}

TEST(DescribedRecord, HasTheDescribedClass) {
  signal::Record record;
  record.name = "IR-02";
  record.label = 1;
  record.shaft_speed_rpm = 1790;
  record.signal = {1, 2, 3};
  const signal::DatasetInfo trained = three_classes();
  const Recording recording =
      recording_of(record, three_classes("other"), {diagnosis::wdcnn, trained});
  EXPECT_EQ(recording.name, "IR-02");
  EXPECT_EQ(recording.true_class, "IR");
  EXPECT_EQ(recording.signal, record.signal);
  record.shaft_speed_rpm = 900;
  EXPECT_ERROR(recording_of(record, three_classes("other"), {diagnosis::wdcnn, trained}),
               Exit::bad_input, "record IR-02: was recorded at 900 rpm");
}

}  // namespace
}  // namespace piae::classification
