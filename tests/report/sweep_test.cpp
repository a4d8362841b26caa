#include "report/sweep.hpp"

#include "base/error.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SweepOptions options_of(const std::string& points, const std::string& centre,
                        const std::string& ratios = "1to1", const std::string& seeds = "0 1") {
  return {.dataset = "cwru",
          .points = {points},
          .centre = {centre},
          .ratios = {ratios},
          .seeds = {seeds}};
}

void expect_usage_error(const SweepOptions& options, const std::string& words) {
  try {
    resolve(options);
    ADD_FAILURE() << "was not refused: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

TEST(SweepPoints, UseTheFoldersOfTheGridAtTheCentre) {
  const Sweep sweep = resolve(options_of("batch=1 batch=5,learning-rate=1e-4", "batch=5"));
  ASSERT_EQ(sweep.points.size(), 3U);
  EXPECT_EQ(sweep.points[0].folder("piae-dt"), "sweep/batch-1");
  EXPECT_EQ(sweep.points[1].folder("piae-dt"), "piae-dt");
  EXPECT_EQ(sweep.points[2].factor, "learning-rate");
  EXPECT_EQ(sweep.points[2].value, "1e-4");
  EXPECT_EQ(sweep.points[2].folder("piae-dt"), "sweep/learning-rate-1e-4");
}

TEST(SweepPoints, RefuseInvalidPoints) {
  expect_usage_error(options_of("batch", "batch"), "'batch' is not FACTOR=VALUE");
  expect_usage_error(options_of("=1", "=1"), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=", "batch="), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=../x", "batch=../x"), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=1 batch=1", "batch=1"), "--points names batch=1 twice");
  expect_usage_error(options_of("batch=1", "batch=5"),
                     "--centre: 'batch=5' is not one of --points");
  expect_usage_error(options_of("", "batch=5"), "--points is empty");
  expect_usage_error(options_of("batch=1", "batch=1", "7to1"), "7to1");
  expect_usage_error(options_of("batch=1", "batch=1", "100to1"), "cannot be combined");
}

class SweepTables : public StoredRun {
 protected:
  /// Adds a cell of piae-dt that recognises `right` of 20 windows.
  void add_cell(const std::string& folder, const std::string& ratio, int generated, int seed,
                int right) {
    save("diagnosis", diagnosis("piae-dt", ratio, generated, seed, right),
         layout_.diagnosis(folder, ratio, seed));
  }
  void add_cells(const std::vector<std::string>& ratios, const std::vector<int>& seeds = {0, 1}) {
    for (const std::string& ratio : ratios) {
      const int generated = ratio == "1to1" ? 495 : 145;
      for (const int seed : seeds) {
        add_cell("piae-dt", ratio, generated, seed, 16 + 2 * seed);
        add_cell("sweep/batch-1", ratio, generated, seed, 10 + 2 * seed);
        add_cell("sweep/depth-4", ratio, generated, seed, 14);
      }
    }
  }
  [[nodiscard]] std::string csv(const SweepOptions& options) const {
    const Sweep sweep = resolve(options);
    return sweep_csv(sweep, rows_of(sweep));
  }
  [[nodiscard]] std::string text(const SweepOptions& options) const {
    const Sweep sweep = resolve(options);
    const std::vector<SweepRow> rows = rows_of(sweep);
    run::Results results;
    sweep_rows(layout_, sweep, run::Held(layout_), results);
    return markdown(sweep_document(sweep, rows, results));
  }
  [[nodiscard]] std::vector<SweepRow> rows_of(const Sweep& sweep) const {
    run::Results results;
    std::vector<SweepRow> rows = sweep_rows(layout_, sweep, run::Held(layout_), results);
    EXPECT_THAT(results.problems, IsEmpty());
    return rows;
  }
  const std::string points_ = "batch=1 batch=5 depth=3 depth=4";
  const std::string centre_ = "batch=5 depth=3";
};

/// The deviation of two values a, b is |a - b| / sqrt(2).
TEST_F(SweepTables, ShowTheCommonPointInEveryFactor) {
  add_cells({"1to1"});
  EXPECT_EQ(csv(options_of(points_, centre_)),
            "dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high\n"
            "cwru,batch,1,1to1,2,55.0000,7.0711,,\n"
            "cwru,batch,5,1to1,2,85.0000,7.0711,,\n"
            "cwru,depth,3,1to1,2,85.0000,7.0711,,\n"
            "cwru,depth,4,1to1,2,70.0000,0.0000,,\n");
}

TEST_F(SweepTables, CoverAllThatTheRunHolds) {
  add_cells({"1to1", "2to1"});
  const std::string all = csv(options_of(points_, centre_, "1to1 2to1"));
  EXPECT_EQ(csv(options_of(points_, centre_, "1to1", "0")), all);
  EXPECT_EQ(csv(options_of(points_, centre_, "2to1", "1")), all);
}

/// The cells of a centre belong to the grid, so a seed without a changed setting does not count.
TEST_F(SweepTables, UseTheSeedsAtWhichASettingWasMoved) {
  add_cells({"1to1", "2to1"});
  add_cell("piae-dt", "1to1", 495, 2, 20);
  std::filesystem::remove(layout_.diagnosis("sweep/batch-1", "1to1", 1));
  const std::string text = csv(options_of(points_, centre_, "1to1", "0"));
  EXPECT_THAT(text, HasSubstr("cwru,batch,1,1to1,1,50.0000,,,\n"));
  EXPECT_THAT(text, HasSubstr("cwru,batch,5,1to1,2,85.0000,7.0711,,\n"));
  EXPECT_THAT(text, HasSubstr("cwru,depth,4,1to1,2,70.0000,0.0000,,\n"));
}

TEST_F(SweepTables, MarkRowsWithFewerSeeds) {
  add_cells({"1to1"});
  std::filesystem::remove(layout_.diagnosis("sweep/batch-1", "1to1", 1));
  const std::string shown = text(options_of(points_, centre_, "1to1", "0"));
  EXPECT_THAT(shown, HasSubstr("2 seeds (0, 1)."));
  EXPECT_THAT(shown, HasSubstr("‡ marks"));
  EXPECT_THAT(shown, HasSubstr("| 1     |                | 1:1 ‡ |        50.00 |\n"
                               "| 5     | as in the grid | 1:1   | 85.00 ± 7.07 |\n"));
}

TEST_F(SweepTables, LeaveOutStaleCells) {
  add_cells({"1to1", "2to1"});
  run::Results results;
  const auto rows = sweep_rows(
      layout_, resolve(options_of(points_, centre_, "1to1", "0")),
      run::Held(layout_, {"seed1/sweep", "seed0/sweep/depth-4/2to1/wdcnn/diagnosis.h5"}), results);
  for (const SweepRow& row : rows)
    EXPECT_THAT(row.accuracy.seeds, ElementsAre(0)) << row.point.value;
  EXPECT_EQ(rows.size(), 7U);
}

TEST_F(SweepTables, HaveABlockForEachValue) {
  add_cells({"1to1", "2to1"}, {1});
  const std::string shown = text(options_of(points_, centre_, "1to1 2to1", "1"));
  EXPECT_THAT(shown, HasSubstr("# Settings of piae-dt on cwru\n"));
  EXPECT_THAT(shown, HasSubstr("## By batch\n\n"
                               "| batch |                | ratio        | accuracy |\n"
                               "|-------|----------------|--------------|---------:|\n"
                               "| 1     |                | 2:1 (3.33:1) |    60.00 |\n"
                               "|       |                | 1:1          |    60.00 |\n"
                               "| 5     | as in the grid | 2:1 (3.33:1) |    90.00 |\n"
                               "|       |                | 1:1          |    90.00 |\n"));
  EXPECT_THAT(shown, HasSubstr("## By depth\n\n"));
}

TEST_F(SweepTables, NameMissingAndForeignCells) {
  add_cells({"1to1", "2to1"});
  std::filesystem::remove(layout_.diagnosis("sweep/batch-1", "1to1", 1));
  save("diagnosis", diagnosis("vae", "1to1", 495, 0, 3),
       layout_.diagnosis("sweep/depth-4", "1to1", 0));
  run::Results results;
  const auto rows =
      sweep_rows(layout_, resolve(options_of(points_, centre_)), run::Held(layout_), results);
  EXPECT_EQ(rows.size(), 6U);
  EXPECT_THAT(results.problems, ElementsAre(HasSubstr("batch 1, ratio 1to1, seed 1: "),
                                            HasSubstr("depth 4, ratio 1to1, seed 0: ")));
  EXPECT_THAT(results.problems[1], HasSubstr("the method is vae, here it must be piae-dt"));
  EXPECT_EQ(results.exit, Exit::bad_input);
  EXPECT_THROW(require_all(results), Error);
}

}  // namespace
}  // namespace piae::report
