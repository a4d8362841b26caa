#include "scoring/confidence.hpp"

#include <gtest/gtest.h>

#include "support/three_classes.hpp"

namespace piae::scoring {
namespace {

/// Returns two windows of class 1, predicted as 1 with a score of 0.8 and as 2 with 0.6.
DiagnosisRecord two_windows() {
  DiagnosisRecord record;
  record.info = three_classes();
  record.labels = {1, 1};
  record.predictions = {1, 2};
  record.scores = {0.1F, 0.8F, 0.1F, 0.2F, 0.2F, 0.6F};
  return record;
}

TEST(Judgements, HaveTheLargestScoreAndCorrectness) {
  const std::vector<Judgement> judgements = judgements_of(two_windows());
  ASSERT_EQ(judgements.size(), 2U);
  EXPECT_FLOAT_EQ(static_cast<float>(judgements[0].score), 0.8F);
  EXPECT_TRUE(judgements[0].right);
  EXPECT_FLOAT_EQ(static_cast<float>(judgements[1].score), 0.6F);
  EXPECT_FALSE(judgements[1].right);
}

/// Each is alone in its bin, off by 0.2 and by 0.6; the more certain half is correct.
TEST(Confidence, HasTheCalibrationErrorAndTheAnswerableShare) {
  const Confidence confidence = confidence_of(two_windows());
  EXPECT_NEAR(confidence.calibration_error, (0.2 + 0.6) / 2, 1e-7);
  EXPECT_EQ(confidence.answerable, 0.5);
  EXPECT_TRUE(confidence.ranks_answers);
}

TEST(Confidence, VotesGiveNoConfidence) {
  DiagnosisRecord record = two_windows();
  record.scores = {0, 1, 0, 0, 0, 1};
  const Confidence confidence = confidence_of(record);
  EXPECT_EQ(confidence.calibration_error, 0.5);
  EXPECT_EQ(confidence.answerable, 0);
  EXPECT_FALSE(confidence.ranks_answers);
}

}  // namespace
}  // namespace piae::scoring
