#include <gmock/gmock.h>

#include "report/recommendation_tables.hpp"
#include "report/recommended_rows.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string gets_wrong =
    "It classifies 13.3 % of the fault windows as healthy (missed faults) and 10.0 % of the "
    "healthy ones as a fault (false alarms). Class IR is recognised least, in 75.0 % of its "
    "windows.";

/// Means: 89 for 86 to 92, -7 for -10 to -4, and -23 for -26 to -20.
TEST(RecommendationSentences, ReportThatLessEffortIsWorse) {
  EXPECT_THAT(
      recommendation_sentences(recommended(seven_seeds(worse))),
      ElementsAre("Recommended on cwru: vae, correct in 96.0 % of the test windows (95 % interval "
                  "96.0 to 96.0, 7 seeds), with 145 generated windows of each fault.",
                  "It is the most accurate of the 3 compared, and those that need less "
                  "are significantly worse: none (-23.0 points, p 0.031) and shift (-7.0 points, p "
                  "0.031).",
                  "A generator and the classifier must be trained.", gets_wrong));
}

/// Differences 1, -2, 1, -2, 1, -2, -1: mean -4/7, deviation 1.512. t with six degrees of freedom
/// is 2.447, so the interval is -1.97 to 0.83.
TEST(RecommendationSentences, ReportThatLessEffortIsAsGood) {
  EXPECT_THAT(
      recommendation_sentences(recommended(seven_seeds(as_good))),
      ElementsAre(StartsWith("Recommended on cwru: shift, correct in 95.4 % of the test windows"),
                  "The most accurate of the 3 compared is vae (96.0 %), but shift is not "
                  "significantly worse (-0.6 points, 95 % interval -2.0 to +0.8, p 0.28) and needs "
                  "less: windows + classifier instead of generator + classifier. Those that "
                  "need still less are significantly worse: none (-23.0 points, p 0.031).",
                  "The classifier must be trained; windows are generated without training.",
                  gets_wrong));
}

TEST(RecommendationSentences, ReportThatFewSeedsCannotDecide) {
  EXPECT_THAT(
      recommendation_sentences(
          recommended({by_classifier_of("nearest", row_with("none", "100to1", {80, 90})),
                       row_with("shift", "2to1", {90, 95})})),
      ElementsAre(
          "Recommended on cwru: shift by wdcnn, correct in 92.5 % of the test "
          "windows (2 seeds), with 145 generated windows of each fault.",
          "It is the most accurate of the 2 compared. With 2 seeds it cannot be decided if those "
          "that need less are as good: none by nearest (-7.5 points). At least 6 seeds are needed.",
          "The classifier must be trained; windows are generated without training.", gets_wrong));
}

TEST(RecommendationSentences, ReportThatNoneNeedsLess) {
  const auto shown = recommendation_sentences(
      recommended({by_classifier_of("nearest", row_with("none", "100to1", {98, 98})),
                   by_classifier_of("nearest", row_with("shift", "2to1", {90, 95}))}));
  EXPECT_THAT(shown[0], HasSubstr(": none by nearest, correct in 98.0 %"));
  EXPECT_THAT(shown[0], EndsWith("(2 seeds), without any generated window."));
  EXPECT_EQ(shown[1], "It is the most accurate of the 2 compared, and none needs less.");
  EXPECT_EQ(shown[2], "It needs no preparation: no window is generated, and nothing is trained.");
  EXPECT_THAT(recommendation_sentences(recommended({row_with("none", "100to1", {70})})),
              testing::Contains("Nothing else was compared."));
}

/// The sentence leaves out false alarms if no healthy window was tested, and missed faults
/// likewise.
TEST(RecommendationSentences, LeaveOutWhatWasNotTested) {
  Recommendation of = recommended(seven_seeds(worse));
  of.by_effort[of.taken].confusion = {3, {0, 0, 0, 0, 9, 1, 0, 0, 0}};
  EXPECT_EQ(recommendation_sentences(of).back(),
            "It classifies 0.0 % of the fault windows as healthy (missed faults). Class IR is "
            "recognised least, in 90.0 % of its windows.");
  of.by_effort[of.taken].confusion = {3, {9, 1, 0, 0, 0, 0, 0, 0, 0}};
  EXPECT_EQ(recommendation_sentences(of).back(),
            "It classifies 10.0 % of the healthy windows as a fault (false alarms). Class Normal "
            "is recognised least, in 90.0 % of its windows.");
  of.by_effort[of.taken].confusion = {};
  EXPECT_EQ(recommendation_sentences(of).size(), 3U);
}

TEST(RecommendationSections, AreByEffortByRatioAndByClass) {
  std::vector<AccuracyRow> rows = seven_seeds(as_good);
  rows.push_back(row_with("shift", "10to1", {80, 81, 82, 83, 84, 85, 86}));
  const auto sections = recommendation_sections(recommendations(rows, results_of(rows)));
  ASSERT_EQ(sections.size(), 3U);
  EXPECT_EQ(sections[0].title, "Which method to take on cwru");
  EXPECT_EQ(
      sections[0].table.plain(),
      "it takes                most accurate  take  accuracy %  95 % interval  behind       p\n"
      "classifier              none                       73.0   [71.0, 75.0]   -23.0  0.0312\n"
      "windows + classifier    shift          yes         95.4   [94.0, 96.8]    -0.6   0.281\n"
      "generator + classifier  vae                        96.0   [96.0, 96.0]       –       –\n");
  EXPECT_THAT(sections[0].findings[1], HasSubstr("not significantly worse (-0.6 points"));
  EXPECT_EQ(sections[1].title, "Which method to take at each ratio on cwru");
  EXPECT_EQ(sections[1].table.plain(),
            "ratio         take   accuracy %  95 % interval  missed faults  false alarms\n"
            "10:1          shift        83.0   [81.0, 85.0]           13.3          10.0\n"
            "2:1 (3.33:1)  shift        95.4   [94.0, 96.8]           13.3          10.0\n");
  EXPECT_EQ(sections[2].table.plain(),
            "class   test windows  recognised\n"
            "Normal            70        90.0\n"
            "IR               140        75.0\n"
            "OR                70       100.0\n");
  EXPECT_THAT(recommendation_sections({}), IsEmpty());
}

TEST(RecommendationCsv, HasALineForEachEffort) {
  const auto rows = seven_seeds(as_good);
  EXPECT_EQ(recommendation_csv(recommendations(rows, results_of(rows))),
            "dataset,ratio,effort,method,classifier,seeds,mean,std,ci95_low,ci95_high,behind,"
            "p_holm,missed_faults,false_alarms,best,recommended\n"
            "cwru,2to1,classifier,none,wdcnn,7,73.0000,2.1602,71.0021,74.9979,-23.0000,0.03125,"
            "13.3333,10.0000,0,0\n"
            "cwru,2to1,windows + classifier,shift,wdcnn,7,95.4286,1.5119,94.0303,96.8268,-0.5714,"
            "0.28125,13.3333,10.0000,0,1\n"
            "cwru,2to1,generator + classifier,vae,wdcnn,7,96.0000,0.0000,96.0000,96.0000,,,13.3333,"
            "10.0000,1,0\n");
}

}  // namespace
}  // namespace piae::report
