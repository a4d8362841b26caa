#include "report/summary.hpp"

#include <gmock/gmock.h>

#include <sstream>
#include <tuple>

#include "report/document.hpp"
#include "report/paper.hpp"
#include "report/tables.hpp"
#include "report/verdict.hpp"
#include "run/grid.hpp"
#include "run/held.hpp"
#include "support/published_tables.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::Le;
using testing::Not;
using testing::SizeIs;

class Summary : public StoredRun {
 protected:
  /// The summary does not show published tables, but they must exist.
  Summary() { write_published_tables(folder_); }

  /// Summarises these methods, which must have all cells, and everything else that the run holds.
  [[nodiscard]] std::string summary_of(const std::string& methods) const {
    const auto [cells, results] =
        collect_held(layout_, grid(methods, "100to1 10to1 2to1"), run::Held(layout_));
    run::require_all(results);
    const auto rows = accuracy_rows(cells, results, Published(folder_.path()));
    return unwrapped(summary_text(cells, results, rows));
  }

  /// Returns the text with single spaces, so that line breaks do not hide a sentence.
  [[nodiscard]] static std::string unwrapped(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_THAT(line, SizeIs(Le(80U)));
    std::istringstream words(text);
    std::string all;
    for (std::string word; words >> word;) all += (all.empty() ? "" : " ") + word;
    return all;
  }

  /// 60, 65 and 65 %: three seeds, enough for an interval.
  void add_three_of_the_baseline() const {
    for (const auto& [seed, right] : {std::pair{0, 12}, {1, 13}, {2, 13}}) {
      add(diagnosis("none", "100to1", 0, seed, right));
    }
  }

  /// Adds `right` of 20 windows for all seeds at the ratio with the most generated windows.
  void add_at_2to1(const std::string& method, int right) const {
    for (const int seed : {0, 1, 2}) {
      add(diagnosis(method, "10to1", 45, seed, 13));
      add(diagnosis(method, "2to1", 145, seed, right));
      if (method != "oracle") add(quality(method, seed, 0.5));
    }
  }
};

TEST_F(Summary, ShowsTheMeanAccuracyOfEachMethodAtEachRatio) {
  add_baseline();
  add_method("vae");
  const std::string text = summary_of("none vae");
  EXPECT_THAT(text, HasSubstr("method 100:1 10:1 2:1"));
  EXPECT_THAT(text, HasSubstr("none 62.5"));
  EXPECT_THAT(text, HasSubstr("vae 75.0 90.0"));
}

TEST_F(Summary, ReportsGainsAndLossesInPoints) {
  add_three_of_the_baseline();
  add_at_2to1("vae", 19);     // 95 %
  add_at_2to1("smote", 9);    // 45 %
  add_at_2to1("oracle", 20);  // 100 %
  const std::string text = summary_of("none vae smote oracle");
  EXPECT_THAT(text, HasSubstr("With 145 generated windows of each fault"));
  EXPECT_THAT(text, HasSubstr("against the 63.3 % without any (3 seeds)"));
  EXPECT_THAT(text, HasSubstr("vae (+31.7) helps and smote (-18.3) harms"));
  EXPECT_THAT(text, HasSubstr("real windows instead (oracle) would give +36.7"));
}

TEST_F(Summary, ReportsNoClearDifferenceIfSeedsDisagree) {
  add(diagnosis("none", "100to1", 0, 0, 12));
  add(diagnosis("none", "100to1", 0, 1, 14));
  add(diagnosis("none", "100to1", 0, 2, 13));
  add_at_2to1("vae", 13);  // 5 points above in one seed, 5 below in another
  EXPECT_THAT(summary_of("none vae"), HasSubstr("vae (+0.0) makes no clear difference"));
}

TEST_F(Summary, ExplainsWhyThePapersMethodDoesNotHelp) {
  add_three_of_the_baseline();
  add_at_2to1("piae-dt", 9);
  const std::string text = summary_of("none piae-dt");
  // The two classes of a stored score have amplitude ratios 4 and 1, line differences 7 and 1 dB.
  EXPECT_THAT(text, HasSubstr("its windows are 250 % as strong as real ones and show the lines of "
                              "their fault 4.0 dB stronger."));
}

TEST_F(Summary, ExplainsAGainOfLessThanHalfOfTheCeilings) {
  add_three_of_the_baseline();
  add_at_2to1("piae-dt", 15);  // 75 %
  add_at_2to1("oracle", 20);   // 100 %
  const std::string text = summary_of("none piae-dt oracle");
  EXPECT_THAT(text,
              HasSubstr("piae-dt gains 11.7 of these 36.7 points: as published, it describes"));
  EXPECT_THAT(text, HasSubstr("its windows are 250 % as strong as real ones"));
}

TEST_F(Summary, DoesNotExplainAGainOfMostOfTheCeilings) {
  add_three_of_the_baseline();
  add_at_2to1("piae-dt", 18);  // 90 %
  add_at_2to1("oracle", 20);
  EXPECT_THAT(summary_of("none piae-dt oracle"), Not(HasSubstr("published")));
}

TEST_F(Summary, DoesNotExplainAGainWithoutACeiling) {
  add_three_of_the_baseline();
  add_at_2to1("piae-dt", 20);
  const std::string text = summary_of("none piae-dt");
  EXPECT_THAT(text, HasSubstr("piae-dt (+36.7) helps."));
  EXPECT_THAT(text, Not(HasSubstr("published")));
}

TEST_F(Summary, ShowsTheSeedsOfAMethodWithFewer) {
  add_three_of_the_baseline();
  add_at_2to1("vae", 19);
  add_at_2to1("smote", 9);
  std::filesystem::remove(layout_.diagnosis("smote", "2to1", 1));
  const std::string text = summary_of("none vae");
  EXPECT_THAT(text, HasSubstr("Accuracy on cwru in percent, mean of up to 3 seeds"));
  EXPECT_THAT(text,
              HasSubstr("vae (+31.7) helps and smote (-17.5, 2 seeds) makes no clear difference"));
}

TEST_F(Summary, DoesNotJudgeByOneOrTwoSeeds) {
  for (const int seed : {0, 1}) {
    add(diagnosis("none", "100to1", 0, seed, 12));
    add(diagnosis("vae", "2to1", 145, seed, 19));
    add(diagnosis("smote", "2to1", 145, seed, 11));
  }
  const auto verdict_on = [&](const std::string& seeds) {
    const run::Grid grid = this->grid("none vae smote", "100to1 2to1", seeds);
    const run::Results results = run::collect(layout_, grid);
    return verdict(results, accuracy_rows(grid, results, Published(folder_.path())));
  };
  const std::string numbers =
      "With 145 generated windows of each fault, in points against the 60.0 % without any: vae "
      "(+35.0) and smote (-5.0). ";
  EXPECT_THAT(verdict_on("0"),
              testing::ElementsAre(
                  numbers + "This is one seed, too few to distinguish an effect from chance."));
  EXPECT_THAT(verdict_on("0 1"),
              testing::ElementsAre(
                  numbers + "These are two seeds, too few to distinguish an effect from chance."));
}

// One cell at another ratio does not become the subject of the sentence.
TEST_F(Summary, UsesARatioThatHalfOfTheMethodsHave) {
  add_three_of_the_baseline();
  for (const char* method : {"vae", "smote", "piae-dt"}) add_at_2to1(method, 19);
  add(diagnosis("vae", "1to1", 495, 0, 20));
  EXPECT_THAT(summary_of("none vae smote piae-dt"), HasSubstr("With 145 generated windows"));
}

/// 15 of 20 windows are correct by class, all by fault type.
TEST_F(Summary, ReportsConditionsAndAccuracyByKind) {
  for (const auto& [method, ratio, generated] :
       {std::tuple{"none", "100to1", 0}, {"vae", "10to1", 45}, {"vae", "2to1", 145}}) {
    scoring::DiagnosisRecord record = diagnosis(method, ratio, generated, 0, 15);
    record.info.classes[2].defect = signal::Defect::inner;
    record.info.conditions = {{"1200 rpm", 1200, true, false, true},
                              {"900 rpm", 900, false, true, true},
                              {"600 rpm", 600, true, false, true}};
    add(record);
  }
  add(quality("vae", 0, 0.5));
  const run::Grid grid = this->grid("none vae", "100to1 10to1 2to1", "0");
  const run::Results results = run::collect(layout_, grid);
  const auto rows = accuracy_rows(grid, results, Published(folder_.path()));
  const std::string text = unwrapped(summary_text(grid, results, rows));
  EXPECT_THAT(text, HasSubstr("Faults are known at 1200 rpm and 600 rpm, and tested at 900 rpm. "));
  EXPECT_THAT(text, HasSubstr("vae 75.0 75.0 By fault type: none 100.0 (100:1), vae 100.0 (2:1)."));
  EXPECT_THAT(markdown(tables(grid, results, rows, Published(folder_.path()), {}, {}, {})),
              HasSubstr("Faults are known at 1200 rpm"));
}

TEST_F(Summary, DoesNotMentionConditionsWithoutAny) {
  add_baseline();
  add_method("vae");
  const std::string text = summary_of("none vae");
  EXPECT_THAT(text, Not(HasSubstr("known at")));
  EXPECT_THAT(text, Not(HasSubstr("kind")));
}

TEST_F(Summary, IsOnlyTheTableWithoutTheBaseline) {
  add_method("vae");
  EXPECT_THAT(summary_of("vae"), Not(HasSubstr("points")));
}

}  // namespace
}  // namespace piae::report
