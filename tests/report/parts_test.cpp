#include "report/parts.hpp"

#include "base/error.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string header =
    "dataset,method,classifier,factor,value,centre,ratio,seeds,mean,std,ci95_low,ci95_high,"
    "pairs,difference,difference_std,difference_ci95_low,difference_ci95_high";

SweepOptions sweep_of(const std::string& points, const std::string& seeds) {
  return {.dataset = "cwru",
          .points = {points},
          .centre = {},
          .ratios = {"1to1"},
          .seeds = {seeds},
          .method = "strike-twin",
          .classifier = "nearest"};
}

class Parts : public StoredRun {
 protected:
  /// Adds a cell of strike-twin by `nearest` that recognises `right` of 20 windows.
  void add_cell(const std::string& folder, const std::string& ratio, int seed, int right) const {
    save("diagnosis", record(ratio, seed, right),
         layout_.diagnosis(folder, ratio, seed, "nearest"));
  }
  [[nodiscard]] scoring::DiagnosisRecord record(const std::string& ratio, int seed,
                                                int right) const {
    return by("nearest", diagnosis("strike-twin", ratio, ratio == "1to1" ? 495 : 145, seed, right));
  }
  /// The method recognises 16, 17 and 18 windows; with known edges 10, 12 and 14.
  void add_three_seeds() const {
    for (const int seed : {0, 1, 2}) {
      add_cell("strike-twin", "1to1", seed, 16 + seed);
      add_cell("sweep@strike-twin/edges-known", "1to1", seed, 10 + 2 * seed);
    }
  }
  [[nodiscard]] std::vector<PartRow> rows_of(const Sweep& sweep, run::Results& results) const {
    return part_rows(sweep_rows(layout_, sweep, run::Held(layout_), results));
  }
  [[nodiscard]] std::string csv(const SweepOptions& options) const {
    const Sweep sweep = resolve(options);
    run::Results results;
    return parts_csv(sweep, rows_of(sweep, results));
  }
  [[nodiscard]] std::string text(const SweepOptions& options) const {
    const Sweep sweep = resolve(options);
    run::Results results;
    const std::vector<PartRow> rows = rows_of(sweep, results);
    return markdown(parts_document(sweep, rows, results));
  }
};

/// Differences of -30, -25 and -20 points have the deviation 5. Student's t with two degrees of
/// freedom is 4.30265, so the interval is 12.4207 to either side.
TEST_F(Parts, AreComparedWithTheMethodSeedBySeed) {
  add_three_seeds();
  EXPECT_EQ(csv(sweep_of("edges=known", "0 1 2")),
            header +
                "\ncwru,strike-twin,nearest,,,1,1to1,3,85.0000,5.0000,72.5793,97.4207,0,,,,\n"
                "cwru,strike-twin,nearest,edges,known,0,1to1,3,60.0000,10.0000,35.1586,84.8414,"
                "3,-25.0000,5.0000,-37.4207,-12.5793\n");
}

TEST_F(Parts, AreComparedAtCommonSeeds) {
  add_three_seeds();
  std::filesystem::remove(layout_.diagnosis("strike-twin", "1to1", 2, "nearest"));
  const std::string rows = csv(sweep_of("edges=known", "0"));
  EXPECT_THAT(rows, HasSubstr(",,,1,1to1,2,82.5000,"));
  EXPECT_THAT(rows, HasSubstr(",1to1,3,60.0000,10.0000,35.1586,84.8414,2,-27.5000,3.5355,,\n"));
}

TEST_F(Parts, UseTheMethodsOwnCellsForItsDefaults) {
  add_three_seeds();
  SweepOptions options = sweep_of("edges=known tilt=0", "0 1 2");
  options.centre = {"tilt=0"};
  EXPECT_THAT(csv(options), HasSubstr("tilt,0,1,1to1,3,85.0000,5.0000,72.5793,97.4207,0,,,,\n"));
  EXPECT_THAT(text(options), HasSubstr("| tilt=0 (as in the grid) |  85.0 ± 5.0 |"));
}

TEST_F(Parts, HaveATableForEachRatio) {
  add_three_seeds();
  add_cell("strike-twin", "2to1", 0, 15);
  add_cell("sweep@strike-twin/edges-known", "2to1", 0, 16);
  const std::string shown = text(sweep_of("edges=known", "0 1 2"));
  EXPECT_THAT(shown, HasSubstr("# Effect of each part of strike-twin on cwru\n"));
  EXPECT_THAT(shown, HasSubstr("percent by nearest, with one setting of strike-twin moved"));
  EXPECT_THAT(shown, HasSubstr("## At 2:1 (3.33:1)\n"));
  EXPECT_THAT(
      shown,
      HasSubstr(
          "## At 1:1\n\n"
          "| setting        |    accuracy | 95 % interval |  difference |  95 % interval |\n"
          "|----------------|------------:|--------------:|------------:|---------------:|\n"
          "| as in the grid |  85.0 ± 5.0 |  [72.6, 97.4] |             |                |\n"
          "| edges=known    | 60.0 ± 10.0 |  [35.2, 84.8] | -25.0 ± 5.0 | [-37.4, -12.6] |\n"));
  EXPECT_THAT(shown, Not(HasSubstr("By fault type")));
  EXPECT_THAT(shown, Not(HasSubstr("‡")));
  std::filesystem::remove(layout_.diagnosis("strike-twin", "1to1", 2, "nearest"));
  EXPECT_THAT(text(sweep_of("edges=known", "0")),
              AllOf(HasSubstr("| as in the grid ‡ |  82.5 ± 3.5 |"), HasSubstr("‡ marks numbers")));
}

/// Both faults become one fault type, so a window taken for the other fault is correct by type.
TEST_F(Parts, ShowAccuracyByKindIfConditionsDiffer) {
  for (const std::string folder : {"strike-twin", "sweep@strike-twin/edges-known"}) {
    scoring::DiagnosisRecord diagnosis = record("1to1", 0, folder == "strike-twin" ? 16 : 10);
    diagnosis.info.conditions = {
        {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = false, .healthy = true},
        {.name = "slow", .shaft_speed_rpm = 900, .known = false, .test = true, .healthy = true}};
    diagnosis.info.classes.back().defect = diagnosis.info.classes[1].defect;
    diagnosis.predictions.back() = 0;
    save("diagnosis", diagnosis, layout_.diagnosis(folder, "1to1", 0, "nearest"));
  }
  EXPECT_THAT(csv(sweep_of("edges=known", "0")),
              AllOf(HasSubstr(",kind_mean,kind_std,kind_ci95_low,kind_ci95_high\n"),
                    HasSubstr(",edges,known,0,1to1,1,50.0000,,,,1,-30.0000,,,,95.0000,,,\n")));
  const std::string shown = text(sweep_of("edges=known", "0"));
  EXPECT_THAT(shown, HasSubstr("By fault type: a window counts as correct"));
  EXPECT_THAT(
      shown,
      HasSubstr("| edges=known    |     50.0 |             – |          95.0 |      -30.0 |"));
}

TEST_F(Parts, NeedTheMethodWithItsOwnSettings) {
  add_three_seeds();
  std::filesystem::remove(layout_.diagnosis("strike-twin", "1to1", 2, "nearest"));
  run::Results results;
  (void)rows_of(resolve(sweep_of("edges=known", "0 1 2")), results);
  ASSERT_EQ(results.problems.size(), 1U);
  EXPECT_THAT(results.problems[0],
              HasSubstr("method strike-twin by nearest, ratio 1to1, seed 2: "));
}

TEST_F(Parts, RefuseAnUnknownMethodOrClassifier) {
  SweepOptions options = sweep_of("edges=known", "0");
  options.method = "strike";
  EXPECT_THROW(resolve(options), Error);
  options = sweep_of("edges=known", "0");
  options.classifier = "nearer";
  EXPECT_THROW(resolve(options), Error);
}

}  // namespace
}  // namespace piae::report
