#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/accuracy_rows.hpp"
#include "report/accuracy_table.hpp"
#include "report/summary.hpp"
#include "report/tables.hpp"
#include "report/verdict.hpp"
#include "run/held.hpp"
#include "support/published_tables.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

AccuracyRow judged_by(const std::string& classifier, AccuracyRow row) {
  row.classifier = classifier;
  return row;
}

TEST(NothingKnown, NamesTheMostAccurateOfEachKind) {
  EXPECT_EQ(most_accurate_without_known({row_with("vae", "10to1", {60, 70}),
                                         judged_by("nearest", row_with("vae", "1to1", {80, 82})),
                                         row_with("smote", "1to1", {75, 76}),
                                         judged_by("lines", row_with("none", "100to1", {70, 71})),
                                         judged_by("edges", row_with("none", "100to1", {50, 51})),
                                         row_with("oracle", "1to1", {99, 98})}),
            "Most accurate: with generated windows vae by nearest (81.0 %, 1:1), by "
            "a rule lines (70.5 %) and with real windows instead oracle by wdcnn (98.5 %, "
            "1:1).");
  EXPECT_EQ(most_accurate_without_known({judged_by("lines", row_with("none", "100to1", {70}))}),
            "Most accurate: by a rule lines (70.0 %).");
  EXPECT_EQ(most_accurate_without_known({}), "");
}

/// Without known fault windows a network cannot be trained on `none`, so gains do not exist.
TEST(NothingKnown, GivesTheVerdictWithoutKnownFaults) {
  run::Results results;
  run::Diagnosis& cell = results.diagnoses.emplace_back();
  const std::vector<AccuracyRow> rows{row_with("oracle", "1to1", {99, 98})};
  EXPECT_EQ(conditions_note(results), "");
  EXPECT_THAT(verdict(results, rows), testing::IsEmpty());
  cell.any_known = false;
  EXPECT_EQ(conditions_note(results), "No fault window was known.");
  EXPECT_THAT(verdict(results, rows),
              testing::ElementsAre(
                  "Most accurate: with real windows instead oracle by wdcnn (98.5 %, 1:1)."));
}

class RunWithoutKnownFaults : public StoredRun {
 protected:
  RunWithoutKnownFaults() { write_published_tables(folder_); }
  void add_without_known(scoring::DiagnosisRecord record) const {
    record.any_known = false;
    if (record.generated_per_class == 0) record.true_ratio.reset();
    add(record);
  }
};

/// `none` has cells by one classifier, the methods by another.
TEST_F(RunWithoutKnownFaults, SaysSoInItsTables) {
  for (const int seed : {0, 1}) {
    add_without_known(diagnosis("oracle", "2to1", 145, seed, 19));
    add_without_known(by("wdcnn-spectrum", diagnosis("none", "100to1", 0, seed, 12 + seed)));
  }
  const auto [cells, results] = collect_held(layout_, grid("oracle", "2to1"), run::Held(layout_));
  run::require_all(results);
  const Published published(folder_.path());
  const auto rows = accuracy_rows(cells, results, published);
  const std::string text =
      markdown(tables(cells, results, rows, published, compare_by_classifier(rows, ""),
                      rank_by_classifier(rows), {}));
  EXPECT_THAT(text, testing::HasSubstr("\nNo fault window was known.\n"));
  EXPECT_THAT(text, testing::HasSubstr("without generated windows, 100:1 (no faults), percent"));
  const std::string summary = summary_text(cells, results, rows);
  EXPECT_THAT(summary, testing::HasSubstr("\nNo fault window was known.\n"));
  EXPECT_THAT(summary, testing::HasSubstr("by a rule wdcnn-spectrum (62.5 %)"));
  EXPECT_THAT(accuracy_csv(rows),
              testing::HasSubstr("cwru,none,wdcnn-spectrum,100to1,0,2,62.5000"));
}

}  // namespace
}  // namespace piae::report
