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
  return {"cwru", {points}, {centre}, {ratios}, {seeds}};
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

TEST(SweepPoints, HaveTheFoldersOfTheGridWhereTheyAreTheCentre) {
  const Sweep sweep = resolve(options_of("batch=1 batch=5,learning-rate=1e-4", "batch=5"));
  ASSERT_EQ(sweep.points.size(), 3U);
  EXPECT_EQ(sweep.points[0].folder(), "sweep/batch-1");
  EXPECT_EQ(sweep.points[1].folder(), "piae-dt");
  EXPECT_EQ(sweep.points[2].factor, "learning-rate");
  EXPECT_EQ(sweep.points[2].value, "1e-4");
  EXPECT_EQ(sweep.points[2].folder(), "sweep/learning-rate-1e-4");
}

TEST(SweepPoints, ThatCannotBeAreRefused) {
  expect_usage_error(options_of("batch", "batch"), "'batch' is not FACTOR=VALUE");
  expect_usage_error(options_of("=1", "=1"), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=", "batch="), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=../x", "batch=../x"), "is not FACTOR=VALUE");
  expect_usage_error(options_of("batch=1 batch=1", "batch=1"), "--points names batch=1 twice");
  expect_usage_error(options_of("batch=1", "batch=5"), "--centre: 'batch=5' is none of --points");
  expect_usage_error(options_of("", "batch=5"), "--points is empty");
  expect_usage_error(options_of("batch=1", "batch=1", "7to1"), "7to1");
  expect_usage_error(options_of("batch=1", "batch=1", "100to1"), "go together");
}

class SweepTables : public StoredRun {
 protected:
  /// A cell of piae-dt, `right` of 20 windows told.
  void add_cell(const std::string& folder, const std::string& ratio, int generated, int seed,
                int right) {
    save("diagnosis", diagnosis("piae-dt", ratio, generated, seed, right),
         layout_.diagnosis(folder, ratio, seed));
  }
  void add_all_cells() {
    for (const auto& [ratio, generated] : {std::pair{"1to1", 495}, std::pair{"2to1", 145}}) {
      add_cell("piae-dt", ratio, generated, 0, 16);
      add_cell("piae-dt", ratio, generated, 1, 18);
      add_cell("sweep/batch-1", ratio, generated, 0, 10);
      add_cell("sweep/batch-1", ratio, generated, 1, 12);
      add_cell("sweep/depth-4", ratio, generated, 0, 14);
      add_cell("sweep/depth-4", ratio, generated, 1, 14);
    }
  }
  const std::string points_ = "batch=1 batch=5 depth=3 depth=4";
  const std::string centre_ = "batch=5 depth=3";
};

/// Of two values a, b the deviation is |a - b| / sqrt(2), and the interval's half 12.7062 |a - b|
/// / 2.
TEST_F(SweepTables, HaveTheCommonPointInEveryFactor) {
  add_all_cells();
  const Sweep sweep = resolve(options_of(points_, centre_));
  run::Results results;
  const auto rows = sweep_rows(layout_, sweep, results);
  EXPECT_THAT(results.problems, IsEmpty());
  EXPECT_EQ(sweep_csv(sweep, rows),
            "dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high\n"
            "cwru,batch,1,1to1,2,55.0000,7.0711,-8.5310,118.5310\n"
            "cwru,batch,5,1to1,2,85.0000,7.0711,21.4690,148.5310\n"
            "cwru,depth,3,1to1,2,85.0000,7.0711,21.4690,148.5310\n"
            "cwru,depth,4,1to1,2,70.0000,0.0000,70.0000,70.0000\n");
}

TEST_F(SweepTables, ForPeopleHaveARatioAColumn) {
  add_all_cells();
  const Sweep sweep = resolve(options_of(points_, centre_, "1to1 2to1", "1"));
  run::Results results;
  const auto rows = sweep_rows(layout_, sweep, results);
  const std::string text = markdown(sweep_document(sweep, rows, results));
  EXPECT_THAT(text, HasSubstr("# Settings of piae-dt on cwru\n"));
  EXPECT_THAT(text, HasSubstr("## By batch\n\n"
                              "| batch |                | 2:1 (3.33:1) |   1:1 |\n"
                              "|-------|----------------|-------------:|------:|\n"
                              "| 1     |                |        60.00 | 60.00 |\n"
                              "| 5     | as in the grid |        90.00 | 90.00 |\n"));
  EXPECT_THAT(text, HasSubstr("## By depth\n\n"
                              "| depth |                | 2:1 (3.33:1) |   1:1 |\n"
                              "|-------|----------------|-------------:|------:|\n"
                              "| 3     | as in the grid |        90.00 | 90.00 |\n"
                              "| 4     |                |        70.00 | 70.00 |\n"));
}

TEST_F(SweepTables, NameEveryCellThatIsMissingOrDoesNotBelong) {
  add_all_cells();
  std::filesystem::remove(layout_.diagnosis("sweep/batch-1", "1to1", 1));
  save("diagnosis", diagnosis("vae", "1to1", 495, 0, 3),
       layout_.diagnosis("sweep/depth-4", "1to1", 0));
  run::Results results;
  const auto rows = sweep_rows(layout_, resolve(options_of(points_, centre_)), results);
  EXPECT_EQ(rows.size(), 2U);
  EXPECT_THAT(results.problems, ElementsAre(HasSubstr("batch 1, ratio 1to1, seed 1: "),
                                            HasSubstr("depth 4, ratio 1to1, seed 0: ")));
  EXPECT_THAT(results.problems[1], HasSubstr("the method is vae, here it must be piae-dt"));
  EXPECT_EQ(results.exit, Exit::bad_input);
  EXPECT_THROW(require_all(results), Error);
}

}  // namespace
}  // namespace piae::report
