#include <gmock/gmock.h>

#include "report/accuracies.hpp"
#include "report/accuracy_rows.hpp"
#include "report/accuracy_table.hpp"
#include "report/comparisons.hpp"
#include "report/labels.hpp"
#include "report/rank_table.hpp"
#include "report/summary.hpp"
#include "report/tables.hpp"
#include "report/verdict.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

AccuracyRow by(const std::string& classifier, AccuracyRow row) {
  row.classifier = classifier;
  return row;
}

AccuracyRow reference_row() {
  return by("nearest", row_with("none", "100to1", {99, 98, 99, 98, 99}));
}

std::vector<AccuracyRow> five_seeds_and_reference() {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(reference_row());
  return rows;
}

/// Two methods by the paper's classifier and by another classifier.
std::vector<AccuracyRow> two_classifiers() {
  std::vector<AccuracyRow> rows = five_seeds_and_reference();
  for (const AccuracyRow& row : five_seeds()) {
    AccuracyRow other = by("wdcnn-spectrum", row);
    for (double& value : other.values) value = 100 - value / 10;
    other.summary = summarise_within(percents, other.values);
    rows.push_back(other);
  }
  return rows;
}

std::vector<std::string> classifiers_of(const std::vector<ClassifierRows>& blocks) {
  std::vector<std::string> names;
  for (const ClassifierRows& block : blocks) names.push_back(block.classifier);
  return names;
}

TEST(ClassifierRows, IncludeTheBaselineOfNearest) {
  EXPECT_THAT(classifiers_of(by_classifier(five_seeds())), ElementsAre("wdcnn"));
  EXPECT_FALSE(by_classifier(five_seeds()).front().reference_row);
  const auto blocks = by_classifier(two_classifiers());
  EXPECT_THAT(classifiers_of(blocks), ElementsAre("wdcnn", "wdcnn-spectrum"));
  for (const ClassifierRows& block : blocks) {
    EXPECT_EQ(block.rows.size(), 5U);
    ASSERT_TRUE(block.reference_row);
    EXPECT_EQ(block.reference_row->values, reference_row().values);
  }
}

TEST(ClassifierRows, ShowNearestAloneIfItHasMoreCells) {
  EXPECT_THAT(classifiers_of(by_classifier({reference_row()})), ElementsAre("nearest"));
  std::vector<AccuracyRow> rows = five_seeds_and_reference();
  rows.push_back(by("nearest", row_with("shift", "10to1", {99, 99, 99, 99, 99})));
  const auto blocks = by_classifier(rows);
  EXPECT_THAT(classifiers_of(blocks), ElementsAre("wdcnn", "nearest"));
  EXPECT_TRUE(blocks[0].reference_row);
  EXPECT_FALSE(blocks[1].reference_row);
}

// Gains, tests and ranks stay within a classifier.
TEST(ClassifierRows, AreComparedWithinTheirClassifier) {
  const std::vector<AccuracyRow> gains = gain_rows(two_classifiers());
  ASSERT_EQ(gains.size(), 8U);
  EXPECT_EQ(gains[0].summary.mean, 13);             // 83 - 70
  EXPECT_NEAR(gains[4].summary.mean, -1.3, 1e-12);  // 91.7 - 93
  EXPECT_EQ(gains[4].classifier, "wdcnn-spectrum");
  const std::string comparisons = comparisons_csv(compare_by_classifier(two_classifiers(), ""));
  EXPECT_THAT(comparisons, HasSubstr("cwru,10to1,shift,wdcnn,piae-dt,5,3.0000,"));
  EXPECT_THAT(comparisons, HasSubstr("cwru,10to1,shift,wdcnn-spectrum,piae-dt,5,-0.3000,"));
  const std::string ranks = ranks_csv(rank_by_classifier(two_classifiers()));
  EXPECT_THAT(ranks, HasSubstr("cwru,10to1,shift,wdcnn,5,1.0000,"));
  EXPECT_THAT(ranks, HasSubstr("cwru,10to1,shift,wdcnn-spectrum,5,3.0000,"));
}

// Holm's correction of one classifier does not count the tests of another.
TEST(ClassifierRows, AreSeparateFamiliesOfTests) {
  EXPECT_EQ(compare_by_classifier(two_classifiers(), "")[0].rows[0].p_holm,
            compare_methods(five_seeds(), "").rows[0].p_holm);
}

TEST(ClassifierRows, HaveNoComparisonWithoutItsOtherSide) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(by("nearest", row_with("none", "100to1", {99, 99, 99, 99, 99})));
  rows.push_back(by("nearest", row_with("shift", "10to1", {99, 99, 99, 99, 99})));
  EXPECT_EQ(compare_by_classifier(rows, "piae-dt").size(), 1U);
  EXPECT_EQ(compare_by_classifier(rows, "shift").size(), 2U);
}

TEST(ClassifierRows, NameTheirClassifierInCsv) {
  const std::string csv = accuracy_csv(two_classifiers());
  EXPECT_THAT(csv, HasSubstr("dataset,method,classifier,ratio,"));
  EXPECT_THAT(csv, HasSubstr("\ncwru,none,nearest,100to1,0,5,98.6000,"));
  EXPECT_THAT(csv, HasSubstr("\ncwru,shift,wdcnn-spectrum,10to1,45,5,91.7000,"));
}

std::string sections_text(const std::vector<AccuracyRow>& rows) {
  Document document{.key = "cwru", .title = "cwru"};
  for (const ClassifierRows& block : by_classifier(rows)) {
    for (Section& section : accuracy_sections(block, Published())) {
      document.sections.push_back(std::move(section));
    }
  }
  return markdown(document);
}

TEST(ClassifierRows, ShowTheBaselineInEveryAccuracyTable) {
  const std::string text = sections_text(five_seeds_and_reference());
  EXPECT_THAT(text, HasSubstr("| none by nearest | 98.60 |       |              |\n"));
  EXPECT_THAT(text, HasSubstr("| run           |           here |     by nearest |\n"));
  EXPECT_THAT(text, HasSubstr("| 2, seed 1     |          70.00 |          98.00 |\n"));
  EXPECT_THAT(text, HasSubstr("| none by nearest | 100:1        |"));
  EXPECT_THAT(text, HasSubstr("needed."));
  EXPECT_THAT(sections_text(five_seeds()), Not(HasSubstr("nearest")));
}

Document tables_of(const std::vector<AccuracyRow>& rows) {
  run::Results results;
  for (const AccuracyRow& row : rows) {
    for (const std::int64_t seed : row.seeds) {
      results.diagnoses.push_back(
          {.method = row.method, .ratio = row.ratio, .classifier = row.classifier, .seed = seed});
    }
  }
  return tables({.dataset = "cwru", .scored = {}, .combinations = {}, .seeds = {0, 1, 2, 3, 4}},
                results, rows, Published(), compare_by_classifier(rows, ""),
                rank_by_classifier(rows));
}

TEST(ClassifierRows, NameTheirClassifierInTitles) {
  for (const Section& section : tables_of(five_seeds_and_reference()).sections) {
    EXPECT_THAT(section.title, Not(HasSubstr(", by "))) << section.title;
  }
  std::vector<std::string> titles;
  std::vector<std::string> keys;
  for (const Section& section : tables_of(two_classifiers()).sections) {
    titles.push_back(section.title);
    keys.push_back(section.key);
  }
  EXPECT_THAT(titles, testing::Contains("Mean accuracy on cwru, percent, by wdcnn"));
  EXPECT_THAT(titles, testing::Contains("Average ranks on cwru, by wdcnn-spectrum"));
  // The paper has numbers for its own classifier only.
  EXPECT_THAT(titles,
              testing::Contains("Accuracy of the methods on cwru, percent, by wdcnn-spectrum"));
  EXPECT_THAT(keys, testing::IsSupersetOf({"accuracy-means", "accuracy-means-wdcnn-spectrum"}));
  EXPECT_THAT(markdown(tables_of(two_classifiers())),
              Not(testing::ContainsRegex("\n[^#\n][^\n]{100}")));
}

// A referee must see it in each table: these classifiers get windows that others do not.
TEST(ClassifierRows, MarkClassifiersThatSeeD) {
  std::vector<AccuracyRow> rows{reference_row()};
  for (const AccuracyRow& row : five_seeds()) rows.push_back(by("dann", row));
  const Document document = tables_of(rows);
  EXPECT_THAT(document.paragraphs.back(), HasSubstr("A classifier that sees D"));
  EXPECT_THAT(markdown(document), HasSubstr("Mean accuracy on cwru, percent, by dann (sees D)\n"));
  EXPECT_THAT(markdown(document), Not(testing::ContainsRegex("dann[^-/ ]|dann [^(]")));
  EXPECT_THAT(accuracy_text(two_classifiers()), Not(HasSubstr("sees D")));
  EXPECT_EQ(about_adapting({"wdcnn", "nearest"}), "");
}

TEST(ClassifierRows, AppearInTheVerdictForNearest) {
  const auto shown = verdict({}, five_seeds_and_reference());
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown.front(), verdict({}, five_seeds()).front());
  EXPECT_THAT(shown.back(), HasSubstr("The classifier nearest, "));
  EXPECT_THAT(shown.back(), HasSubstr("98.6 % of the test windows with the known windows only."));
  EXPECT_THAT(verdict({}, {reference_row()}), IsEmpty());
}

TEST(ClassifierRows, HaveOneSummaryTableEach) {
  const run::Grid grid{
      .dataset = "cwru", .scored = {}, .combinations = {}, .seeds = {0, 1, 2, 3, 4}};
  const std::string one = summary_text(grid, {}, five_seeds_and_reference());
  EXPECT_THAT(one, HasSubstr("\nnone by nearest   98.6"));
  EXPECT_THAT(one, Not(HasSubstr("\nby wdcnn")));
  const std::string two = summary_text(grid, {}, two_classifiers());
  EXPECT_THAT(two, HasSubstr("\nby wdcnn\nmethod"));
  EXPECT_THAT(two, HasSubstr("\nby wdcnn-spectrum\nmethod"));
}

}  // namespace
}  // namespace piae::report
