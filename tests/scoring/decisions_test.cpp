#include "scoring/decisions.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace piae::scoring {
namespace {

using testing::IsEmpty;

using Groups = std::vector<std::vector<std::size_t>>;

/// Seven windows of two records, not in time order. In record 4, class 1 has windows at 0, 10, 20
/// and 30, class 0 one at 15; record 2 has two of class 1.
const std::vector<Label> labels{1, 1, 0, 1, 1, 1, 1};
const Places places{.record = {4, 4, 4, 2, 4, 4, 2}, .first_sample = {30, 0, 15, 5, 20, 10, 500}};

TEST(ConsecutiveGroups, AreWithinOneRecordAndClass) {
  EXPECT_EQ(consecutive_groups(labels, places, 2), (Groups{{3, 6}, {1, 5}, {4, 0}}));
}

TEST(ConsecutiveGroups, LeaveOutRemaindersAndShortRecords) {
  EXPECT_EQ(consecutive_groups(labels, places, 3), (Groups{{1, 5, 4}}));
  EXPECT_THAT(consecutive_groups(labels, places, 5), IsEmpty());
}

TEST(ConsecutiveGroups, OfSizeOneAreAllWindows) {
  EXPECT_EQ(consecutive_groups(labels, places, 1), (Groups{{2}, {3}, {6}, {1}, {5}, {4}, {0}}));
}

/// A class in two conditions is in two records; a group must not span both.
TEST(ConsecutiveGroups, AreWithinOneCondition) {
  const Places two{.record = {0, 1, 0, 1}, .first_sample = {0, 20, 10, 30}};
  EXPECT_EQ(consecutive_groups(std::vector<Label>{1, 1, 1, 1}, two, 2), (Groups{{0, 2}, {1, 3}}));
  EXPECT_THAT(consecutive_groups(std::vector<Label>{1, 1, 1, 1}, two, 3), IsEmpty());
}

TEST(ConsecutiveGroups, NeedOnePlacePerLabelAndAWindow) {
  EXPECT_THROW(consecutive_groups(std::vector<Label>{1}, places, 2), std::logic_error);
  EXPECT_THROW(consecutive_groups(labels, {places.record, {}}, 2), std::logic_error);
  EXPECT_THROW(consecutive_groups(labels, places, 0), std::logic_error);
}

/// Two windows favour class 0 slightly, one favours class 2 strongly: 0.9, 0.6 and 1.5.
TEST(Decide, ChoosesTheClassWithTheLargestSum) {
  const std::vector<float> scores{0.4F, 0.3F, 0.3F, 0.4F, 0.3F, 0.3F, 0.1F, 0, 0.9F};
  EXPECT_EQ(decide(scores, 3, std::vector<std::size_t>{0, 1, 2}), 2);
  EXPECT_EQ(decide(scores, 3, std::vector<std::size_t>{0, 1}), 0);
}

TEST(Decide, VotesWithoutScoresAndBreaksTiesByOrder) {
  const std::vector<float> votes{0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_EQ(decide(votes, 3, std::vector<std::size_t>{0, 1, 2}), 1);
  EXPECT_EQ(decide(votes, 3, std::vector<std::size_t>{0, 1, 2, 3}), 1);
  EXPECT_EQ(decide(votes, 3, std::vector<std::size_t>{0, 1}), 1);
}

/// Class 0 has 30 windows of one record, class 1 has 10 of another, in time order. The first six of
/// class 0 are wrong, which makes one decision of three wrong. Class 1 has three wrong ones of ten,
/// and its one decision is correct.
TEST(DecisionRates, HavePlainAndBalancedAccuracy) {
  std::vector<Label> truth(40, 0);
  Places where;
  std::vector<float> votes;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool is_second = i >= 30;
    if (is_second) truth[i] = 1;
    where.record.push_back(is_second ? 1 : 0);
    where.first_sample.push_back(static_cast<std::int64_t>(1000 * i));
    const bool is_right = is_second ? i >= 33 : i >= 6;
    const bool is_for_second = is_second == is_right;
    votes.insert(votes.end(), {is_for_second ? 0.0F : 1.0F, is_for_second ? 1.0F : 0.0F});
  }
  const std::vector<DecisionRates> rates = decision_rates(truth, votes, 2, where);
  ASSERT_EQ(rates.size(), 2U) << "no class has a decision over 60 windows";
  EXPECT_EQ(rates[0].windows, 1U);
  EXPECT_EQ(rates[0].decisions, 40U);
  EXPECT_DOUBLE_EQ(rates[0].accuracy, 31 / 40.0);
  EXPECT_DOUBLE_EQ(rates[0].balanced, (24 / 30.0 + 7 / 10.0) / 2);
  EXPECT_EQ(rates[1].windows, 10U);
  EXPECT_EQ(rates[1].decisions, 4U);
  EXPECT_DOUBLE_EQ(rates[1].accuracy, 3 / 4.0);
  EXPECT_DOUBLE_EQ(rates[1].balanced, (2 / 3.0 + 1) / 2);
}

/// Ten windows of class 0, nine of class 1.
TEST(DecisionRates, AreLeftOutIfAClassHasNoDecision) {
  std::vector<Label> truth(19, 0);
  std::fill(truth.begin() + 10, truth.end(), 1);
  Places where{.record = std::vector<std::int32_t>(19), .first_sample = {}};
  for (std::int64_t i = 0; i < 19; ++i) where.first_sample.push_back(i);
  const auto rates = decision_rates(truth, std::vector<float>(38, 0.5F), 2, where);
  ASSERT_EQ(rates.size(), 1U);
  EXPECT_EQ(rates[0].windows, 1U);
}

}  // namespace
}  // namespace piae::scoring
