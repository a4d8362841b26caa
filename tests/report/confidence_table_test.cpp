#include <algorithm>

#include "report/decisions_table.hpp"
#include "report/paper.hpp"
#include "report/tables.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::Not;

class ConfidenceTable : public StoredRun {
 protected:
  /// `right` of 20 windows are recognised with a score of 1; the others get a wrong class with 0.5.
  [[nodiscard]] scoring::DiagnosisRecord knowing(const std::string& method,
                                                 const std::string& ratio, int generated, int seed,
                                                 int right) const {
    scoring::DiagnosisRecord record = diagnosis(method, ratio, generated, seed, right);
    for (std::size_t i = 0; i < 20; ++i) {
      record.scores[3 * i + index_of(record.predictions[i])] =
          i < static_cast<std::size_t>(right) ? 1 : 0.5F;
    }
    return record;
  }
  /// none recognises 12 and 14 windows; vae 10 at 10to1 and 19 at 2to1.
  void add_two_seeds() const {
    for (const int seed : {0, 1}) {
      add(knowing("none", "100to1", 0, seed, 12 + 2 * seed));
      add(knowing("vae", "10to1", 45, seed, 10));
      add(knowing("vae", "2to1", 145, seed, 19));
      add(quality("vae", seed, 0.5));
    }
  }
  [[nodiscard]] run::Results results(const run::Grid& grid) const {
    return run::collect(layout_, grid);
  }
  [[nodiscard]] std::string text(const run::Grid& grid) const {
    const auto rows = accuracy_rows(grid, results(grid), Published{});
    return markdown(tables(grid, results(grid), rows, Published{}, {}, {}));
  }
};

/// Wrong windows lie in their own bin, off by 0.5: 8 and 6 of 20 windows, 10, and 1. With 12
/// correct windows no wrong window may be answered, because all wrong ones have the same score.
/// With 19 the wrong window may be answered.
TEST_F(ConfidenceTable, HasAllMethodsAndRatiosInItsCsv) {
  add_two_seeds();
  const auto rows = accuracy_rows(grid_, results(grid_), Published{});
  EXPECT_EQ(confidence_csv(rows, results(grid_)),
            "dataset,method,classifier,ratio,seeds,calibration_error_mean,calibration_error_std,"
            "calibration_error_ci95_low,calibration_error_ci95_high,answerable_mean,answerable_std,"
            "answerable_ci95_low,answerable_ci95_high,tells\n"
            "cwru,none,wdcnn,100to1,2,17.5000,3.5355,,,65.0000,7.0711,,,1\n"
            "cwru,vae,wdcnn,10to1,2,25.0000,0.0000,,,50.0000,0.0000,,,1\n"
            "cwru,vae,wdcnn,2to1,2,2.5000,0.0000,,,100.0000,0.0000,,,1\n");
}

TEST_F(ConfidenceTable, ShowsEachMethodWithTheMostWindows) {
  add_two_seeds();
  const std::string shown = text(grid_);
  EXPECT_THAT(shown, HasSubstr("\n## Share answered at 95 % precision on cwru, percent\n"));
  EXPECT_THAT(
      shown,
      HasSubstr("| method | ratio        | calibration error |      answered | 95 % interval |\n"
                "|--------|--------------|------------------:|--------------:|--------------:|\n"
                "| none   | 100:1        |      17.50 ± 3.54 |  65.00 ± 7.07 |             – |\n"
                "| vae    | 2:1 (3.33:1) |       2.50 ± 0.00 | 100.00 ± 0.00 |             – |\n"));
  EXPECT_THAT(shown, HasSubstr("comes from the same windows"));
  EXPECT_THAT(shown, Not(HasSubstr("No confidence")));
}

TEST_F(ConfidenceTable, NamesClassifiersWithoutConfidence) {
  add_two_seeds();
  for (const int seed : {0, 1}) {
    scoring::DiagnosisRecord votes = by("nearest", diagnosis("none", "100to1", 0, seed, 18));
    for (std::size_t i = 0; i < 20; ++i) votes.scores[3 * i + index_of(votes.predictions[i])] = 1;
    add(votes);
  }
  run::GridOptions options{"cwru", {"none vae"}, {"100to1 10to1 2to1"}, {"0 1"}, {"wdcnn"}};
  std::string shown = text(resolve(options));
  EXPECT_THAT(shown,
              HasSubstr("| none by nearest | 100:1        |      10.00 ± 0.00 |   0.00 ± 0.00 |"));
  std::ranges::replace(shown, '\n', ' ');
  EXPECT_THAT(shown, HasSubstr("No confidence is reported by none by nearest:"));
}

}  // namespace
}  // namespace piae::report
