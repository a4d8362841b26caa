#include "scoring/refusal.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

using testing::DoubleNear;
using testing::Pointwise;

/// Correct, correct, wrong, correct, wrong by falling score.
const std::vector<Judgement> five_answers{
    {0.5, false}, {0.9, true}, {0.6, true}, {0.8, true}, {0.7, false}};

/// The precisions of the first 1 to 5 are 1, 1, 2/3, 3/4 and 3/5.
TEST(AnswerableShare, IsTheLargestShareThatReachesThePrecision) {
  EXPECT_DOUBLE_EQ(answerable_share(five_answers, 95), 0.4);
  EXPECT_DOUBLE_EQ(answerable_share(five_answers, 76), 0.4);
  EXPECT_DOUBLE_EQ(answerable_share(five_answers, 75), 0.8) << "reached again after the wrong one";
  EXPECT_DOUBLE_EQ(answerable_share(five_answers, 60), 1);
}

TEST(AnswerableShare, IsZeroIfNoThresholdReachesThePrecision) {
  EXPECT_EQ(answerable_share(std::vector<Judgement>{{0.9, false}, {0.8, true}}, 95), 0);
}

/// 19 of 20 are 95 %.
TEST(AnswerableShare, IsAllOrNothingForEqualScores) {
  std::vector<Judgement> votes(20, {1, true});
  votes[3].right = false;
  EXPECT_EQ(answerable_share(votes, 95), 1);
  votes[7].right = false;
  EXPECT_EQ(answerable_share(votes, 95), 0);
}

/// The highest score includes a wrong prediction: no threshold separates the two.
TEST(AnswerableShare, DoesNotSeparateEqualScores) {
  EXPECT_EQ(answerable_share(std::vector<Judgement>{{0.9, true}, {0.9, false}, {0.1, false}}, 95),
            0);
}

TEST(AnswerableShare, NeedsAPrediction) {
  EXPECT_THROW(answerable_share({}, 95), std::logic_error);
}

TEST(PrecisionByShare, StartsWithTheHighestScores) {
  EXPECT_THAT(precision_by_share(five_answers, 5),
              Pointwise(DoubleNear(1e-12), {1.0, 1.0, 2 / 3.0, 3 / 4.0, 3 / 5.0}));
}

/// Of 1.25, 2.5, 3.75 and 5 windows, 1.25, 2, 2.75 and 3 are correct.
TEST(PrecisionByShare, CountsFractionsOfAWindow) {
  EXPECT_THAT(precision_by_share(five_answers, 4),
              Pointwise(DoubleNear(1e-12), {1.0, 2 / 2.5, 2.75 / 3.75, 3 / 5.0}));
}

TEST(PrecisionByShare, IsConstantForEqualScores) {
  const std::vector<Judgement> votes{{1, true}, {1, false}, {1, true}, {1, true}};
  EXPECT_THAT(precision_by_share(votes, 8),
              Pointwise(DoubleNear(1e-12), std::vector<double>(8, 0.75)));
}

TEST(PrecisionByShare, NeedsPredictionsAndSteps) {
  EXPECT_THROW(precision_by_share({}, 4), std::logic_error);
  EXPECT_THROW(precision_by_share(five_answers, 0), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring
