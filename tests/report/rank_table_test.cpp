#include "report/rank_table.hpp"

#include <gmock/gmock.h>

#include "report/accuracy_rows.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string ranks_header =
    "dataset,ratio,method,classifier,seeds,average_rank,friedman_p,critical_difference\n";

/// Worked by hand. At 10to1 all five seeds have the same order: p is 1 / 6^4. At 2to1 shift is
/// first in three: chi squared 7.6, F 12.667, and for (2, 8) degrees of freedom p is (1 + F /
/// 4)^-4. The critical difference is 2.3437 sqrt(12 / 30).
TEST(Ranks, MatchHandCalculation) {
  EXPECT_EQ(ranks_csv({rank_methods(five_seeds())}),
            ranks_header +
                "cwru,10to1,none,wdcnn,5,3.0000,0.000771605,1.4823\n"
                "cwru,10to1,shift,wdcnn,5,1.0000,0.000771605,1.4823\n"
                "cwru,10to1,piae-dt,wdcnn,5,2.0000,0.000771605,1.4823\n"
                "cwru,2to1,none,wdcnn,5,3.0000,0.00331776,1.4823\n"
                "cwru,2to1,shift,wdcnn,5,1.4000,0.00331776,1.4823\n"
                "cwru,2to1,piae-dt,wdcnn,5,1.6000,0.00331776,1.4823\n"
                "cwru,all,none,wdcnn,5,3.0000,,\n"
                "cwru,all,shift,wdcnn,5,1.2000,,\n"
                "cwru,all,piae-dt,wdcnn,5,1.8000,,\n");
}

std::string ranks_text(const std::vector<AccuracyRow>& rows) {
  return markdown({"cwru", "cwru", {}, rank_sections(rank_methods(rows))});
}

std::string note(const std::vector<AccuracyRow>& rows) {
  return rank_sections(rank_methods(rows)).front().note;
}

TEST(Ranks, HaveAColumnForEachRatio) {
  EXPECT_THAT(ranks_text(five_seeds()), HasSubstr("## Average ranks on cwru\n\n"));
  EXPECT_THAT(ranks_text(five_seeds()),
              HasSubstr("| method  |     10:1 | 2:1 (3.33:1) | all cells |\n"
                        "|---------|---------:|-------------:|----------:|\n"
                        "| none    |     3.00 |         3.00 |      3.00 |\n"
                        "| shift   |     1.00 |         1.40 |      1.20 |\n"
                        "| piae-dt |     2.00 |         1.60 |      1.80 |\n"
                        "| p       | 0.000772 |      0.00332 |           |\n"));
}

TEST(Ranks, ExcludeTheCeiling) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("oracle", "10to1", {99, 99, 99, 99, 99}));
  EXPECT_EQ(ranks_csv({rank_methods(rows)}), ranks_csv({rank_methods(five_seeds())}));
}

TEST(Ranks, LeaveOutAMethodRatherThanOtherCells) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("vae", "10to1", {60}));
  EXPECT_EQ(ranks_csv({rank_methods(rows)}), ranks_csv({rank_methods(five_seeds())}));
  EXPECT_THAT(note(rows), HasSubstr("left out, because they have too few: vae."));
  EXPECT_THAT(note(five_seeds()), Not(HasSubstr("left out")));
}

/// Four methods at seeds 1 to 4 have more cells than three methods at all five.
TEST(Ranks, UseTheSeedsThatMostMethodsHave) {
  std::vector<AccuracyRow> rows = five_seeds();
  rows.push_back(row_with("vae", "10to1", {60, 60, 60, 60}, 1));
  rows.push_back(row_with("vae", "2to1", {60, 60, 60, 60}, 1));
  EXPECT_THAT(ranks_csv({rank_methods(rows)}), HasSubstr("cwru,10to1,vae,wdcnn,4,4.0000,"));
  EXPECT_THAT(note(rows), HasSubstr("Ranks use the cells that all of these methods have."));
}

/// With two seeds and three methods p is at least 1 / 3!, and ranks differ by at most 2.
TEST(Ranks, ReportWhatFewSeedsCannotShow) {
  const std::vector<AccuracyRow> rows{row_with("none", "100to1", {70, 70}),
                                      row_with("shift", "10to1", {81, 82}),
                                      row_with("piae-dt", "10to1", {80, 80})};
  EXPECT_THAT(ranks_text(rows), HasSubstr("| p       | 0.167 † |"));
  EXPECT_THAT(note(rows), HasSubstr("more than 2.34 differ significantly at 0.05 (Nemenyi; Demsar "
                                    "2006), but ranks of 3 methods cannot differ that much."));
  EXPECT_THAT(note(rows),
              HasSubstr("† marks p values that so few seeds cannot make smaller than 0.05."));
  EXPECT_THAT(ranks_text(five_seeds()), Not(HasSubstr("†")));
}

TEST(Ranks, HaveNoTestForOneSeed) {
  const std::vector<AccuracyRow> rows{row_with("shift", "10to1", {81}),
                                      row_with("piae-dt", "10to1", {80})};
  EXPECT_EQ(ranks_csv({rank_methods(rows)}), ranks_header +
                                                 "cwru,10to1,shift,wdcnn,1,1.0000,,\n"
                                                 "cwru,10to1,piae-dt,wdcnn,1,2.0000,,\n"
                                                 "cwru,all,shift,wdcnn,1,1.0000,,\n"
                                                 "cwru,all,piae-dt,wdcnn,1,2.0000,,\n");
  EXPECT_THAT(ranks_text(rows), Not(HasSubstr("Friedman")));
  EXPECT_THAT(ranks_text(rows), Not(HasSubstr("| p ")));
}

TEST(Ranks, AreEmptyWithoutRows) {
  const std::vector<AccuracyRow> alone{row_with("piae-dt", "10to1", {1, 2})};
  EXPECT_EQ(ranks_csv({rank_methods(alone)}), ranks_header);
  EXPECT_THAT(rank_sections(rank_methods(alone)), IsEmpty());
  const std::vector<AccuracyRow> apart{row_with("vae", "10to1", {1, 2}),
                                       row_with("piae-dt", "2to1", {1, 2})};
  EXPECT_EQ(ranks_csv({rank_methods(apart)}), ranks_header);
}

}  // namespace
}  // namespace piae::report
