#include "report/decisions_table.hpp"

#include <algorithm>

#include "report/paper.hpp"
#include "report/tables.hpp"
#include "run/held.hpp"
#include "support/stored_run.hpp"
#include "support/stored_tested_windows.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string decisions_header =
    "dataset,method,classifier,ratio,windows,seeds,decisions,mean,std,ci95_low,ci95_high,"
    "balanced_mean,balanced_std,balanced_ci95_low,balanced_ci95_high\n";

/// 20 windows of class 1 and 10 of class 2, one record each.
class DecisionsTable : public StoredRun {
 protected:
  DecisionsTable() : labels_(30, 1), places_(one_record(30)) {
    std::fill_n(labels_.begin() + 20, 10, 2);
    std::fill_n(places_.record.begin() + 20, 10, 1);
  }
  /// By vote, recognises the first `right` windows of class 1 and all of class 2.
  [[nodiscard]] scoring::DiagnosisRecord record_of(const std::string& method,
                                                   const std::string& ratio, int generated,
                                                   int seed, int right) const {
    scoring::DiagnosisRecord record = diagnosis(method, ratio, generated, seed, 0);
    record.labels = labels_;
    record.predictions.assign(30, 2);
    std::fill_n(record.predictions.begin(), right, 1);
    record.scores.assign(90, 0);
    for (std::size_t i = 0; i < 30; ++i) record.scores[3 * i + index_of(record.predictions[i])] = 1;
    return record;
  }
  void add_two_seeds() const {
    for (const int seed : {0, 1}) {
      add(record_of("none", "100to1", 0, seed, seed == 0 ? 0 : 12));
      add(record_of("vae", "10to1", 45, seed, 4));
      add(record_of("vae", "2to1", 145, seed, 18));
      save_tested_windows(layout_, "cwru", seed, labels_, places_);
    }
  }
  [[nodiscard]] run::Collected collected() const {
    return run::collect_held(layout_,
                             {.dataset = "cwru", .scored = {}, .combinations = {}, .seeds = {}},
                             run::Held(layout_));
  }
  [[nodiscard]] static std::vector<AccuracyRow> rows_in(const run::Collected& all) {
    return accuracy_rows(all.grid, all.results, Published{});
  }
  [[nodiscard]] std::string csv() const {
    const run::Collected all = collected();
    return decisions_csv(rows_in(all), all.results);
  }
  [[nodiscard]] std::string text() const {
    const run::Collected all = collected();
    return markdown(tables(all.grid, all.results, rows_in(all), Published{}, {}, {}));
  }

  std::vector<Label> labels_;
  scoring::Places places_;
};

/// Over ten windows, class 1 has two decisions and class 2 one. none recognises 0 and 12 windows of
/// class 1: 10 and 22 of 30 windows and 1 and 2 of 3 decisions are correct; the recall of the
/// classes is 0 and 1/2, and 1. vae recognises 4 windows and none of the decisions; at 2to1 18
/// windows and both decisions.
TEST_F(DecisionsTable, HasAllMethodsAndRatiosInItsCsv) {
  add_two_seeds();
  EXPECT_EQ(csv(), decisions_header +
                       "cwru,none,wdcnn,100to1,1,2,30,53.3333,28.2843,,,65.0000,21.2132,,\n"
                       "cwru,none,wdcnn,100to1,10,2,3,50.0000,23.5702,,,62.5000,17.6777,,\n"
                       "cwru,vae,wdcnn,10to1,1,2,30,46.6667,0.0000,,,60.0000,0.0000,,\n"
                       "cwru,vae,wdcnn,10to1,10,2,3,33.3333,0.0000,,,50.0000,0.0000,,\n"
                       "cwru,vae,wdcnn,2to1,1,2,30,93.3333,0.0000,,,95.0000,0.0000,,\n"
                       "cwru,vae,wdcnn,2to1,10,2,3,100.0000,0.0000,,,100.0000,0.0000,,\n");
}

TEST_F(DecisionsTable, ShowsEachMethodWithTheMostWindows) {
  add_two_seeds();
  const std::string shown = text();
  EXPECT_THAT(shown,
              HasSubstr("\n## Decisions over several windows of a record on cwru, percent\n\n"));
  EXPECT_THAT(
      shown,
      HasSubstr(
          "| method              | ratio        |      1 window |    10 windows | 60 windows |\n"
          "|---------------------|--------------|--------------:|--------------:|-----------:|\n"
          "| none                | 100:1        | 65.00 ± 21.21 | 62.50 ± 17.68 |          – |\n"
          "| vae                 | 2:1 (3.33:1) |  95.00 ± 0.00 | 100.00 ± 0.00 |          – |\n"
          "| decisions of a seed |              |            30 |             3 |          – |\n"));
  EXPECT_THAT(shown, Not(HasSubstr("are left out")));
  EXPECT_THAT(shown, HasSubstr("successive among the"));
}

TEST_F(DecisionsTable, DoesNotMentionSuccessiveWindowsForTheBlockedSplit) {
  scoring::DiagnosisRecord record = record_of("none", "100to1", 0, 0, 12);
  record.protocol = signal::Protocol::blocked;
  add(record);
  save_tested_windows(layout_, "cwru", 0, labels_, places_);
  EXPECT_THAT(text(),
              testing::AllOf(HasSubstr("Decisions over"), Not(HasSubstr("successive among"))));
}

TEST_F(DecisionsTable, CoversEachClassifierAndTheBaseline) {
  add_two_seeds();
  for (const int seed : {0, 1}) {
    add(by("nearest", record_of("none", "100to1", 0, seed, 20)));
    add(by("wdcnn-spectrum", record_of("none", "100to1", 0, seed, 12)));
  }
  const std::string shown = text();
  EXPECT_THAT(shown, HasSubstr("| none by nearest     | 100:1        | 100.00 ± 0.00 |"));
  EXPECT_THAT(shown, HasSubstr("of a record on cwru, percent, by wdcnn-spectrum\n"));
  EXPECT_THAT(csv(), HasSubstr("cwru,none,nearest,100to1,10,2,3,100.0000,"));
}

/// For seed 1 the places of the test windows are unknown.
TEST_F(DecisionsTable, MarksMeansOfFewerSeeds) {
  add_two_seeds();
  std::filesystem::remove(layout_.windows("A", 1));
  EXPECT_THAT(csv(), HasSubstr("cwru,none,wdcnn,100to1,10,1,3,33.3333,,,,50.0000,,,\n"));
  EXPECT_THAT(text(), testing::AllOf(HasSubstr(" 50.00 ‡ |"), HasSubstr("‡ marks")));
}

TEST_F(DecisionsTable, IsLeftOutWithALineWithoutTestWindows) {
  add_two_seeds();
  for (const int seed : {0, 1}) std::filesystem::remove(layout_.windows("A", seed));
  EXPECT_EQ(csv(), decisions_header);
  std::string shown = text();
  std::ranges::replace(shown, '\n', ' ');
  EXPECT_THAT(shown, HasSubstr(" Decisions over several windows of a record are left out: the run "
                               "does not hold the test windows (A.h5 of each seed)"));
  EXPECT_THAT(shown, Not(HasSubstr("## Decisions")));
  const run::Collected all = collected();
  EXPECT_THAT(decision_sections(by_classifier(rows_in(all)).front(), all.results), IsEmpty());
}

}  // namespace
}  // namespace piae::report
