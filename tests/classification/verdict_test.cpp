#include "classification/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "classification/judged.hpp"

namespace piae::classification {
namespace {

using testing::ElementsAre;

// Two of three windows are class 1: (0.8 + 0.8 + 0.1) / 3 against (0.1 + 0.1 + 0.8) / 3.
TEST(Verdict, IsTheClassOfTheGreatestMeanProbability) {
  const Verdict verdict = judged("a", {1, 0, 1});
  EXPECT_EQ(verdict.label, 1);
  EXPECT_NEAR(verdict.probability, 1.7 / 3, 1e-6);
  EXPECT_DOUBLE_EQ(verdict.share, 2.0 / 3);
  EXPECT_EQ(verdict.share_unknown, 0);
  EXPECT_FALSE(verdict.unknown);
  EXPECT_THAT(verdict.predictions.labels, ElementsAre(1, 0, 1));
  EXPECT_THAT(verdict.start_s,
              ElementsAre(0, testing::DoubleEq(1024 / 12000.0), testing::DoubleEq(2048 / 12000.0)));
  EXPECT_EQ(verdict.recording.name, "a");
}

// A tone resembles nothing in the training set, so its class does not count.
TEST(Verdict, UsesWindowsThatAreNotUnknown) {
  const Verdict verdict = judged("a", {-1, 2, 2, -1});
  EXPECT_TRUE(verdict.is_unknown(0));
  EXPECT_FALSE(verdict.is_unknown(1));
  EXPECT_EQ(verdict.share_unknown, 0.5);
  EXPECT_FALSE(verdict.unknown);  // exactly half
  EXPECT_EQ(verdict.label, 2);
  EXPECT_NEAR(verdict.probability, 0.8, 1e-6);
}

TEST(Verdict, IsUnknownIfMoreThanHalfOfTheWindowsAre) {
  const Verdict verdict = judged("a", {-1, 2, -1});
  EXPECT_TRUE(verdict.unknown);
  EXPECT_EQ(verdict.label, 2);
  const Verdict all = judged("b", {-1, -1});
  EXPECT_TRUE(all.unknown);
  EXPECT_EQ(all.share_unknown, 1);
  EXPECT_EQ(all.label, 0);  // the class of the unknown windows
  EXPECT_NEAR(all.probability, 0.8, 1e-6);
}

TEST(Verdict, HasAWindowAtEachStep) {
  diagnosis::KeptClassifier classifier = classifier_of_toys();
  const Verdict verdict = judge(recording_of_windows("a", {0, 0}), classifier, 300);
  ASSERT_EQ(verdict.start_s.size(), 4U);  // at 0, 300, 600 and 900 of 2048
  EXPECT_DOUBLE_EQ(verdict.start_s[3], 900 / 12000.0);
}

// n/2 (1 - d/D) at 30 Hz, for CWRU's bearing.
TEST(Verdict, HasTheLinesAtTheSpeedOfTheRecording) {
  Recording recording = recording_of_windows("a", std::vector<int>(20, 0));
  recording.shaft_speed_rpm = 900;
  diagnosis::KeptClassifier classifier = classifier_of_toys();
  const Verdict verdict = judge(recording, classifier, judged_length);
  EXPECT_NEAR(inspection::line_of(verdict.lines, signal::Defect::outer).hz,
              impacts_of_classes_hz[2] / 2, 1e-9);
  EXPECT_FALSE(verdict.envelope.power.empty());
  // The shown part: 3.5 times the highest line.
  EXPECT_NEAR(static_cast<double>(verdict.envelope.power.size()) * verdict.envelope.bin_hz,
              3.5 * impacts_of_classes_hz[1] / 2, verdict.envelope.bin_hz);
}

}  // namespace
}  // namespace piae::classification
