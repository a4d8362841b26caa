#include "report/recommendation.hpp"

#include <gmock/gmock.h>

#include "report/recommended_rows.hpp"

namespace piae::report {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

std::vector<std::string> methods_by_effort(const Recommendation& of) {
  std::vector<std::string> names;
  for (const Candidate& each : of.by_effort) {
    names.push_back(each.row.method + "/" + each.row.classifier);
  }
  return names;
}

TEST(Effort, CountsWhatMustBeMadeOrTrained) {
  EXPECT_EQ(effort_of("none", "nearest"), Effort::nothing);
  EXPECT_EQ(effort_of("none", "envelope-rule"), Effort::nothing);
  EXPECT_EQ(effort_of("shift", "nearest"), Effort::windows);
  EXPECT_EQ(effort_of("none", "wdcnn"), Effort::classifier);
  EXPECT_EQ(effort_of("shift", "symptom-net"), Effort::windows_and_classifier);
  EXPECT_EQ(effort_of("vae", "nearest"), Effort::generator);
  EXPECT_EQ(effort_of("piae-dt", "wdcnn"), Effort::generator_and_classifier);
  EXPECT_EQ(effort_of("toy", "wdcnn"), Effort::generator_and_classifier)
      << "nobody knows what it takes";
  EXPECT_LT(Effort::windows, Effort::classifier);
}

TEST(Recommendation, IsTheBestIfLessEffortIsSignificantlyWorse) {
  const Recommendation of = recommended(seven_seeds(worse));
  EXPECT_EQ(of.compared, 3U);
  EXPECT_THAT(methods_by_effort(of), ElementsAre("none/wdcnn", "shift/wdcnn", "vae/wdcnn"));
  EXPECT_TRUE(of.can_decide);
  EXPECT_EQ(of.best, 2U);
  EXPECT_EQ(of.taken, 2U);
  EXPECT_THAT(of.by_effort[0].behind->p_holm, Optional(DoubleEq(0.03125)));
  EXPECT_THAT(of.by_effort[1].behind->p_holm, Optional(DoubleEq(0.03125)));
  EXPECT_EQ(of.by_effort[1].behind->paired.difference.mean, -7);
  EXPECT_FALSE(of.by_effort[2].behind.has_value());
}

TEST(Recommendation, IsLessEffortIfNotSignificantlyWorse) {
  const Recommendation of = recommended(seven_seeds(as_good));
  EXPECT_EQ(of.most_accurate().row.method, "vae");
  EXPECT_EQ(of.recommended().row.method, "shift");
  EXPECT_THAT(of.recommended().behind->p_holm, Optional(DoubleEq(36.0 / 128)));
}

/// Six seeds give no p below 2 / 2^6, which the correction for two tests makes 0.0625.
TEST(Recommendation, IsTheBestOfTooFewSeedsWithAWarning) {
  std::vector<AccuracyRow> rows;
  for (const AccuracyRow& row : seven_seeds(as_good)) {
    rows.push_back(row_with(row.method, row.ratio, {row.values.begin(), row.values.end() - 1}));
  }
  const Recommendation of_six = recommended(rows);
  EXPECT_FALSE(of_six.can_decide);
  EXPECT_EQ(of_six.recommended().row.method, "vae");
  EXPECT_EQ(of_six.seeds_to_decide(), 7U);
  // One seed cannot be tested.
  const Recommendation of_one =
      recommended({row_with("none", "100to1", {70}), row_with("shift", "2to1", {90})});
  EXPECT_FALSE(of_one.can_decide);
  EXPECT_EQ(of_one.recommended().row.method, "shift");
  EXPECT_EQ(of_one.seeds_to_decide(), 6U);
}

TEST(Recommendation, IsTheLeastEffortOfEquallyAccurateMethods) {
  const Recommendation of =
      recommended({row_with("vae", "2to1", {100, 100}), row_with("shift", "2to1", {100, 100}),
                   by_classifier_of("nearest", row_with("shift", "2to1", {100, 100})),
                   by_classifier_of("nearest", row_with("none", "100to1", {90, 100}))});
  EXPECT_TRUE(of.several_classifiers);
  EXPECT_THAT(methods_by_effort(of),
              ElementsAre("none/nearest", "shift/nearest", "shift/wdcnn", "vae/wdcnn"));
  EXPECT_EQ(of.best, 1U);
}

/// More tests would need more seeds, so only the most accurate of each effort is tested.
TEST(Recommendation, ComparesTheMostAccurateOfEachEffort) {
  std::vector<AccuracyRow> rows = seven_seeds(worse);
  for (const char* const method : {"smote", "oversample", "resample"}) {
    rows.push_back(row_with(method, "2to1", {60, 60, 60, 60, 60, 60, 60}));
  }
  const Recommendation of = recommended(rows);
  EXPECT_EQ(of.compared, 6U);
  EXPECT_TRUE(of.can_decide);
  EXPECT_THAT(of.by_effort[1].behind->p_holm, Optional(DoubleEq(0.03125)));
  EXPECT_EQ(of.by_effort[1].row.method, "shift");
}

TEST(Recommendation, IsNeverACeiling) {
  const std::vector<AccuracyRow> rows{row_with("oracle", "2to1", {99, 99})};
  EXPECT_THAT(recommendations(rows, results_of(rows)), IsEmpty());
  EXPECT_EQ(main_recommendation({}), nullptr);
}

/// Keeps the largest block without missing cells: two pairs at seven seeds, then three at six.
TEST(Recommendation, ComparesOnlyTheSameSeeds) {
  std::vector<AccuracyRow> rows = seven_seeds(worse);
  rows[2] = row_with("vae", "2to1", {100});
  const Recommendation of = recommended(rows);
  EXPECT_THAT(of.left_out, ElementsAre("vae"));
  EXPECT_EQ(of.compared, 2U);
  EXPECT_EQ(of.recommended().row.method, "shift");
  rows[2] = row_with("vae", "2to1", {96, 96, 96, 96, 96, 96});
  const Recommendation of_six = recommended(rows);
  EXPECT_THAT(of_six.left_out, IsEmpty());
  EXPECT_THAT(of_six.most_accurate().row.seeds, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(of_six.by_effort[0].row.summary.mean, 72.5) << "of these seeds alone";
}

TEST(Recommendation, StartsAtTheRatioWithTheMostWindows) {
  std::vector<AccuracyRow> rows = seven_seeds(worse);
  rows.push_back(row_with("shift", "10to1", {80, 81, 82, 83, 84, 85, 86}));
  rows.push_back(row_with("vae", "10to1", {79, 80, 81, 82, 83, 84, 85}));
  std::vector<Recommendation> all = recommendations(rows, results_of(rows));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].ratio, "10to1");
  EXPECT_EQ(all[0].recommended().row.method, "shift");
  EXPECT_EQ(main_recommendation(all)->ratio, "2to1");
  // The main recommendation is not at a ratio that few pairs have.
  for (const char* const method : {"smote", "oversample", "resample", "randomise"}) {
    rows.push_back(row_with(method, "10to1", {60, 60, 60, 60, 60, 60, 60}));
  }
  all = recommendations(rows, results_of(rows));
  EXPECT_EQ(main_recommendation(all)->ratio, "10to1");
}

TEST(Recommendation, IsNoneWithoutGeneratedWindows) {
  const Recommendation of = recommended({row_with("none", "100to1", {70, 71})});
  EXPECT_EQ(of.ratio, "100to1");
  EXPECT_EQ(of.compared, 1U);
  EXPECT_EQ(of.recommended().row.method, "none");
}

/// Without known fault windows, `none` is a rule that learns from healthy windows.
TEST(Recommendation, ComparesRulesWithoutKnownFaults) {
  const Recommendation of =
      recommended({by_classifier_of("envelope-rule", row_with("none", "100to1", {80, 80})),
                   by_classifier_of("exclusion-rule", row_with("none", "100to1", {85, 86})),
                   by_classifier_of("symptom-net", row_with("piae-dt-zero", "2to1", {84, 84}))});
  EXPECT_THAT(methods_by_effort(of),
              ElementsAre("none/exclusion-rule", "piae-dt-zero/symptom-net"));
  EXPECT_EQ(of.recommended().row.classifier, "exclusion-rule");
}

TEST(Recommendation, PoolsTheConfusionOfAllSeeds) {
  EXPECT_EQ(recommended(seven_seeds(worse)).recommended().confusion.at(1, 0), 7 * 4);
}

}  // namespace
}  // namespace piae::report
