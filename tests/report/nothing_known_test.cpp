#include "report/nothing_known.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/accuracy_rows.hpp"
#include "report/condition_notes.hpp"
#include "report/verdict.hpp"

namespace piae::report {
namespace {

AccuracyRow judged_by(const std::string& classifier, AccuracyRow row) {
  row.classifier = classifier;
  return row;
}

TEST(NothingKnown, TheMostAccurateOfEachKindIsNamed) {
  EXPECT_EQ(most_accurate_without_known({row_with("vae", "10to1", {60, 70}),
                                         judged_by("nearest", row_with("vae", "1to1", {80, 82})),
                                         row_with("smote", "1to1", {75, 76}),
                                         judged_by("lines", row_with("none", "100to1", {70, 71})),
                                         judged_by("edges", row_with("none", "100to1", {50, 51})),
                                         row_with("oracle", "1to1", {99, 98})}),
            "Right in most test windows: with generated windows vae by nearest (81.0 %, 1:1), by "
            "a rule lines (70.5 %) and with real windows in their place oracle by wdcnn (98.5 %, "
            "1:1).");
  EXPECT_EQ(most_accurate_without_known({judged_by("lines", row_with("none", "100to1", {70}))}),
            "Right in most test windows: by a rule lines (70.0 %).");
  EXPECT_EQ(most_accurate_without_known({}), "");
}

/// Nothing is a gain over `none` by a network then, which would have nothing to learn from.
TEST(NothingKnown, IsTheVerdictOfARunWithoutKnownFaults) {
  run::Results results;
  run::Diagnosis& cell = results.diagnoses.emplace_back();
  const std::vector<AccuracyRow> rows{row_with("oracle", "1to1", {99, 98})};
  EXPECT_EQ(conditions_note(results), "");
  EXPECT_THAT(verdict(results, rows), testing::IsEmpty());
  cell.any_known = false;
  EXPECT_EQ(conditions_note(results), "No fault window was known.");
  EXPECT_THAT(verdict(results, rows),
              testing::ElementsAre("Right in most test windows: with real windows in their place "
                                   "oracle by wdcnn (98.5 %, 1:1)."));
}

}  // namespace
}  // namespace piae::report
