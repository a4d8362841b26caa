#include "report/comparisons.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "base/error.hpp"
#include "report/accuracy_rows.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string comparisons_header =
    "dataset,ratio,method,classifier,against,seeds,mean_difference,ci95_low,ci95_high,rank_"
    "biserial,p,p_"
    "holm\n";

std::string csv(const std::vector<AccuracyRow>& rows, const std::string& against = "") {
  return comparisons_csv({compare_methods(rows, against)});
}

std::string text(const std::vector<AccuracyRow>& rows, const std::string& against = "") {
  const auto sections = comparison_sections(compare_methods(rows, against));
  return markdown({"cwru", "cwru", {}, sections});
}

/// Worked by hand. Half-width of an interval: 2.776445 times the deviation / sqrt(5), with
/// deviations 1.5811, 3.5355 and, for the means 0, 2, 3, 0, 5, 2.1213. Of the 32 sign patterns, 2,
/// 20 and (of 8 without the zeros) 2 are as extreme. Holm: with two methods, the smaller p doubles.
TEST(Comparisons, MatchHandCalculation) {
  EXPECT_EQ(csv(five_seeds()),
            comparisons_header +
                "cwru,10to1,none,wdcnn,piae-dt,5,-10.0000,-10.0000,-10.0000,-1.0000,0.0625,0.125\n"
                "cwru,2to1,none,wdcnn,piae-dt,5,-20.0000,-20.0000,-20.0000,-1.0000,0.0625,0.125\n"
                "cwru,mean,none,wdcnn,piae-dt,5,-15.0000,-15.0000,-15.0000,-1.0000,0.0625,0.125\n"
                "cwru,10to1,shift,wdcnn,piae-dt,5,3.0000,1.0368,4.9632,1.0000,0.0625,0.125\n"
                "cwru,2to1,shift,wdcnn,piae-dt,5,1.0000,-3.3899,5.3899,0.3333,0.625,0.625\n"
                "cwru,mean,shift,wdcnn,piae-dt,5,2.0000,-0.6340,4.6340,1.0000,0.25,0.25\n");
}

/// A ceiling is not a method: it gets no corrected p and does not raise the p of methods.
TEST(Comparisons, ExcludeCeilingsFromTheCorrection) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("oracle", "10to1", {99, 98, 97, 96, 95}));
  EXPECT_THAT(csv(rows),
              HasSubstr("cwru,10to1,shift,wdcnn,piae-dt,5,3.0000,1.0368,4.9632,1.0000,0.0625,"
                        "0.125\n"));
  EXPECT_THAT(csv(rows), testing::ContainsRegex("cwru,10to1,oracle,.*,0.0625,\n"));
  EXPECT_THAT(text(rows), HasSubstr("|         0.0625 † |\n"));
}

/// Only shift has a row at 1to1, which would otherwise move its mean by 10 points.
TEST(Comparisons, AverageOverTheRatiosThatBothHave) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("shift", "1to1", {99, 99, 99, 99, 99}));
  EXPECT_THAT(csv(rows), HasSubstr("\ncwru,mean,shift,wdcnn,piae-dt,5,2.0000,-0.6340,4.6340,"));
  EXPECT_THAT(csv(rows, "shift"),
              HasSubstr("\ncwru,mean,piae-dt,wdcnn,shift,5,-2.0000,-4.6340,0.6340,"));
}

TEST(Comparisons, HaveABlockForEachMethodAndARowForEachRatio) {
  EXPECT_THAT(text(five_seeds()), HasSubstr("## Accuracy minus that of piae-dt on cwru\n\n"));
  EXPECT_THAT(text(five_seeds()), HasSubstr("| method | ratio        |    difference |    95 % "
                                            "interval | effect |         p (Holm) |\n"
                                            "|--------|--------------|--------------:|-------------"
                                            "----:|-------:|-----------------:|\n"
                                            "| none   | 10:1         | -10.00 ± 0.00 | [-10.00, "
                                            "-10.00] |  -1.00 | 0.0625 (0.125) † |\n"
                                            "|        | 2:1 (3.33:1) | -20.00 ± 0.00 | [-20.00, "
                                            "-20.00] |  -1.00 | 0.0625 (0.125) † |\n"
                                            "|        | mean of 2    | -15.00 ± 0.00 | [-15.00, "
                                            "-15.00] |  -1.00 | 0.0625 (0.125) † |\n"
                                            "| shift  | 10:1         |  +3.00 ± 1.58 |   [+1.04, "
                                            "+4.96] |  +1.00 | 0.0625 (0.125) † |\n"
                                            "|        | 2:1 (3.33:1) |  +1.00 ± 3.54 |   [-3.39, "
                                            "+5.39] |  +0.33 |  0.625 (0.625) † |\n"
                                            "|        | mean of 2    |  +2.00 ± 2.12 |   [-0.63, "
                                            "+4.63] |  +1.00 |    0.25 (0.25) † |\n"));
}

TEST(Comparisons, UseTheLatestSubjectOrTheRequestedOne) {
  std::vector<AccuracyRow> rows = five_seeds();
  EXPECT_EQ(compare_methods(rows, "").against, "piae-dt");
  EXPECT_EQ(compare_methods(rows, "shift").against, "shift");
  EXPECT_THAT(csv(rows, "shift"), HasSubstr("cwru,10to1,piae-dt,wdcnn,shift,5,-3.0000,"));
  EXPECT_THAT(csv(rows, "none"), HasSubstr("cwru,2to1,piae-dt,wdcnn,none,5,20.0000,"));
  rows.push_back(row_with("piae-dt-phase", "10to1", {1, 2, 3, 4, 5}));
  EXPECT_EQ(compare_methods(rows, "").against, "piae-dt-phase");
}

/// strike-twin is made for faults known in other conditions than they are tested in.
TEST(Comparisons, UseTheMethodMadeForTheDataset) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("strike-twin", "10to1", {1, 2, 3, 4, 5}));
  EXPECT_EQ(compare_methods(rows, "").against, "strike-twin");
  rows.push_back(row_with("piae-dt-phase", "10to1", {1, 2, 3, 4, 5}));
  EXPECT_EQ(compare_methods(rows, "").against, "piae-dt-phase");
  for (AccuracyRow& row : rows) row.speed_ratio = 0.75;
  EXPECT_EQ(compare_methods(rows, "").against, "strike-twin");
  EXPECT_EQ(compare_methods(rows, "shift").against, "shift");
  std::erase_if(rows, [](const AccuracyRow& row) { return row.method == "strike-twin"; });
  EXPECT_EQ(compare_methods(rows, "").against, "piae-dt-phase");
}

TEST(Comparisons, RefuseAMethodWithoutCells) {
  try {
    compare_methods(five_seeds(), "vae");
    FAIL() << "compared with nothing";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_THAT(error.what(), HasSubstr("--against vae"));
    EXPECT_THAT(error.what(), HasSubstr("none shift piae-dt"));
  }
}

TEST(Comparisons, AreEmptyWithoutRows) {
  const std::vector<AccuracyRow> alone{row_with("piae-dt", "10to1", {1, 2})};
  EXPECT_EQ(csv(alone), comparisons_header);
  EXPECT_THAT(comparison_sections(compare_methods(alone, "")), IsEmpty());
  const std::vector<AccuracyRow> others{row_with("vae", "10to1", {1, 2}),
                                        row_with("smote", "10to1", {1, 2})};
  EXPECT_EQ(csv(others), comparisons_header) << "nobody to compare with";
  const std::vector<AccuracyRow> apart{row_with("vae", "10to1", {1, 2}),
                                       row_with("piae-dt", "2to1", {1, 2})};
  EXPECT_EQ(csv(apart), comparisons_header) << "no ratio in common";
}

TEST(Comparisons, HaveNoTestForOneSeed) {
  const std::vector<AccuracyRow> rows{row_with("shift", "10to1", {81}),
                                      row_with("piae-dt", "10to1", {80})};
  EXPECT_EQ(csv(rows), comparisons_header + "cwru,10to1,shift,wdcnn,piae-dt,1,1.0000,,,,,\n");
  EXPECT_THAT(text(rows), HasSubstr("| shift  | 10:1  |      +1.00 |\n"));
  EXPECT_THAT(text(rows), Not(HasSubstr("p (Holm)")));
  EXPECT_THAT(text(rows), HasSubstr("A single seed cannot be tested"));
}

std::vector<AccuracyRow> of_seeds(std::size_t seeds) {
  return {row_with("shift", "10to1", std::vector<double>(seeds, 80)),
          row_with("vae", "10to1", std::vector<double>(seeds, 95)),
          row_with("piae-dt", "10to1", std::vector<double>(seeds, 70))};
}

/// 2 / 2^6 is below 0.05, but not twice as much; 2 * 2 / 2^7 is.
TEST(Comparisons, ReportTooFewSeeds) {
  const auto caution = [](std::size_t seeds) {
    std::string all = text(of_seeds(seeds));
    std::ranges::replace(all, '\n', ' ');  // the paragraph is wrapped
    return all;
  };
  EXPECT_THAT(caution(5), HasSubstr("5 seeds cannot give a p below 0.0625, which Holm's correction "
                                    "for 2 makes 0.125"));
  EXPECT_THAT(caution(6), HasSubstr("below 0.0312, which Holm's correction for 2 makes 0.0625"));
  EXPECT_THAT(caution(7), Not(HasSubstr("cannot")));
}

TEST(Comparisons, MarkPValuesThatCannotBeSmall) {
  EXPECT_THAT(text(of_seeds(6)), HasSubstr("| 0.0312 (0.0625) † |\n"));
  EXPECT_THAT(text(of_seeds(6)), HasSubstr("marks p values that cannot be small"));
  EXPECT_THAT(text(of_seeds(7)), Not(HasSubstr("†")));
}

/// Two seeds have no interval. The largest possible interval in points ends at 100.
TEST(Comparisons, HaveNoImpossibleInterval) {
  const std::string two = csv(of_seeds(2));
  EXPECT_THAT(two, HasSubstr("cwru,10to1,shift,wdcnn,piae-dt,2,10.0000,,,1.0000,0.5,1\n"));
  EXPECT_THAT(text(of_seeds(2)), Not(HasSubstr("95 %")));
  const std::vector<AccuracyRow> wide{row_with("shift", "10to1", {100, 20, 100}),
                                      row_with("piae-dt", "10to1", {0, 20, 0})};
  EXPECT_THAT(csv(wide), HasSubstr(",3,66.6667,-76.7551,100.0000,"));
}

/// shift has seeds 0 to 4 at 10to1, and 3 and 4 at 2to1; vae has only seed 0 of 10to1.
std::vector<AccuracyRow> with_gaps() {
  return {row_with("none", "100to1", {70, 70, 70, 70, 70}),
          row_with("vae", "10to1", {60}),
          row_with("piae-dt", "10to1", {80, 80, 80, 80, 80}),
          row_with("piae-dt", "2to1", {90, 90, 90, 90, 90}),
          row_with("shift", "10to1", {81, 82, 83, 84, 85}),
          row_with("shift", "2to1", {86, 95}, 3)};
}

/// Each pair uses the seeds that both have: 86 - 90 and 95 - 90 at 2to1. The mean over both ratios
/// uses the same two seeds: (84 + 86) / 2 - 85 and (85 + 95) / 2 - 85. One seed of vae cannot be
/// tested, so each family has two tests, of none and shift.
TEST(Comparisons, UseTheSeedsOfBothMethods) {
  const std::string pairs = csv(with_gaps(), "piae-dt");
  EXPECT_THAT(pairs, HasSubstr("cwru,10to1,vae,wdcnn,piae-dt,1,-20.0000,,,,,\n"));
  EXPECT_THAT(pairs, Not(HasSubstr("2to1,vae")));
  EXPECT_THAT(pairs, Not(HasSubstr("mean,vae")));
  EXPECT_THAT(pairs,
              HasSubstr("cwru,10to1,shift,wdcnn,piae-dt,5,3.0000,1.0368,4.9632,1.0000,0.0625,0.125"
                        "\n"));
  EXPECT_THAT(pairs, HasSubstr("cwru,2to1,shift,wdcnn,piae-dt,2,0.5000,,,0.3333,1,1\n"));
  EXPECT_THAT(pairs, HasSubstr("cwru,mean,shift,wdcnn,piae-dt,2,2.5000,,,1.0000,"));
  EXPECT_THAT(pairs, HasSubstr("cwru,mean,none,wdcnn,piae-dt,5,-15.0000,"));
}

TEST(Comparisons, MarkTheMethodsWithFewerSeeds) {
  const std::string table = text(with_gaps(), "piae-dt");
  EXPECT_THAT(table, HasSubstr("| none    | 10:1 "));
  EXPECT_THAT(table,
              HasSubstr("| vae ‡   | 10:1         |        -20.00 |                – |      – "
                        "|                – |\n"));
  EXPECT_THAT(table, HasSubstr("| shift ‡ | 10:1 "));
}

/// A seed of a new ratio for one method does not change existing comparisons.
TEST(Comparisons, StayCompleteIfAPartIsRequestedLater) {
  std::vector<AccuracyRow> more = five_seeds();
  more.push_back(row_with("shift", "1to1", {99}));
  more.push_back(row_with("vae", "10to1", {60}));
  std::istringstream before(csv(five_seeds()));
  const std::string after = csv(more);
  for (std::string line; std::getline(before, line);) EXPECT_THAT(after, HasSubstr(line + '\n'));
}

TEST(Comparisons, MarkTheCeiling) {
  std::vector<AccuracyRow> rows = of_seeds(5);
  rows.push_back(row_with("oracle", "10to1", std::vector<double>(5, 97)));
  EXPECT_THAT(text(rows), HasSubstr("| oracle (ceiling) | 10:1 "));
  EXPECT_THAT(text(rows, "oracle"), HasSubstr("minus that of oracle (ceiling) on"));
}

}  // namespace
}  // namespace piae::report
