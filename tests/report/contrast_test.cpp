#include "report/contrast.hpp"

#include "base/error.hpp"
#include "report/accuracy_rows.hpp"
#include "report/ratio_means.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::Not;

/// With overlap: none 70 and 80, vae 90 and 94 at 10to1. Without: 60 and 60, 90 and 90.
Contrast two_protocols() {
  const std::vector<AccuracyRow> with{row_with("none", "100to1", {70, 80}),
                                      row_with("vae", "10to1", {90, 94})};
  const std::vector<AccuracyRow> without{row_with("none", "100to1", {60, 60}),
                                         row_with("vae", "10to1", {90, 90})};
  return contrast({"results/a", "cwru", signal::Protocol::random, with_means(with)},
                  {"results/a-blocked", "cwru", signal::Protocol::blocked, with_means(without)});
}

const std::string contrast_header =
    "with,without,method,ratio,with_mean,with_std,without_mean,without_std,seeds,mean_difference,"
    "ci95_low,ci95_high,rank_biserial,p,p_holm\n";

/// The deviation of two values a, b is |a - b| / sqrt(2). Two of four sign patterns are as extreme;
/// of the two without the zero, both are.
TEST(Contrast, MatchesHandCalculation) {
  EXPECT_EQ(
      contrast_csv(two_protocols()),
      contrast_header +
          "random,blocked,none,100to1,75.0000,7.0711,60.0000,0.0000,2,15.0000,,,1.0000,0.5,0.5\n"
          "random,blocked,vae,10to1,92.0000,2.8284,90.0000,0.0000,2,2.0000,,,1.0000,1,1\n");
}

TEST(Contrast, ShowsBothSidesAndTheirDifference) {
  const std::string text = markdown(contrast_document(two_protocols()));
  EXPECT_THAT(text, HasSubstr("# cwru: random against blocked\n\nEffect of random:"));
  EXPECT_THAT(text, HasSubstr("## Accuracy, random against blocked, percent\n\n"
                              "| method | ratio |       random |      blocked |\n"
                              "|--------|-------|-------------:|-------------:|\n"
                              "| none   | 100:1 | 75.00 ± 7.07 | 60.00 ± 0.00 |\n"
                              "| vae    | 10:1  | 92.00 ± 2.83 | 90.00 ± 0.00 |\n"));
  EXPECT_THAT(text, HasSubstr("## Difference, random minus blocked, points\n\n"));
  EXPECT_THAT(text, HasSubstr("| method | ratio |    difference | effect |    p (Holm) |\n"
                              "|--------|-------|--------------:|-------:|------------:|\n"
                              "| none   | 100:1 | +15.00 ± 7.07 |  +1.00 | 0.5 (0.5) † |\n"
                              "| vae    | 10:1  |  +2.00 ± 2.83 |  +1.00 |     1 (1) † |\n"));
}

TEST(Contrast, KeepsTheMeanOfAMethodWithItsRatios) {
  const std::vector<AccuracyRow> rows{row_with("vae", "10to1", {70}), row_with("vae", "1to1", {80}),
                                      row_with("shift", "10to1", {90}),
                                      row_with("shift", "1to1", {94})};
  const Contrast both = contrast({"results/a", "cwru", signal::Protocol::random, with_means(rows)},
                                 {"results/b", "cwru", signal::Protocol::random, with_means(rows)});
  EXPECT_THAT(markdown(contrast_document(both)),
              HasSubstr("| vae    | 10:1      | 70.00 | 70.00 |\n"
                        "|        | 1:1       | 80.00 | 80.00 |\n"
                        "|        | mean of 2 | 75.00 | 75.00 |\n"
                        "| shift  | 10:1      | 90.00 "));
}

TEST(Contrast, NamesItsSidesByTheDifference) {
  const Side side{
      "results/a", "cwru", signal::Protocol::random, {row_with("none", "100to1", {70})}};
  Side other = side;
  other.dataset = "cwru-as-published";
  EXPECT_EQ(
      contrast_csv(contrast(other, side)),
      contrast_header + "cwru-as-published,cwru,none,100to1,70.0000,,70.0000,,1,0.0000,,,,,\n");
  EXPECT_THAT(markdown(contrast_document(contrast(other, side))),
              testing::StartsWith("# cwru-as-published against cwru\n"));
  other.protocol = signal::Protocol::blocked;
  EXPECT_THAT(contrast_csv(contrast(other, side)),
              HasSubstr("\ncwru-as-published blocked,cwru random,none,"));
  other = side;
  other.run = "results/b";
  EXPECT_THAT(contrast_csv(contrast(other, side)), HasSubstr("\nb,a,none,"));
  EXPECT_THROW(contrast(side, side), Error);
}

/// Two runs of the same cells: RUN/cwru and other/cwru.
class ContrastOfRuns : public StoredRun {
 protected:
  ContrastOfRuns() {
    add_all();
    std::filesystem::copy(folder_.path() / "run", folder_.path() / "other",
                          std::filesystem::copy_options::recursive);
  }
  [[nodiscard]] Contrast read(const run::GridOptions& requested,
                              const std::vector<std::string>& leave_out = {}) const {
    return read_contrast({folder_.path() / "run" / "cwru", (other_.folder() / "").string()},
                         requested, leave_out);
  }
  const run::Layout other_{folder_.path() / "other", "cwru"};
  const run::GridOptions all_{"", {"none vae"}, {"100to1 10to1 2to1"}, {"0 1"}};
  const run::GridOptions part_{"", {"none"}, {"100to1"}, {"1"}};
};

TEST_F(ContrastOfRuns, HasTheCellsOfBothAndTheirMean) {
  const Contrast contrast = read(all_);
  const Side& side = contrast.with;
  EXPECT_EQ(side.dataset, "cwru");
  EXPECT_EQ(side.protocol, signal::Protocol::random);
  EXPECT_EQ(side.run.filename(), "run");
  EXPECT_EQ(contrast.without.run.filename(), "other");
  ASSERT_EQ(side.rows.size(), 4U);
  EXPECT_EQ(side.rows.back().ratio, mean_of_ratios);
  EXPECT_THAT(side.rows.back().values, testing::ElementsAre(80, 85));
}

TEST_F(ContrastOfRuns, RefusesAMissingCell) {
  std::filesystem::remove(other_.diagnosis("vae", "2to1", 1));
  try {
    FAIL() << "took a run with a hole: " << read(all_).rows.size();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::input_missing);
  }
}

TEST_F(ContrastOfRuns, CoversAllCellsThatBothHold) {
  EXPECT_EQ(contrast_csv(read(part_)), contrast_csv(read(all_)));
  std::filesystem::remove(other_.diagnosis("vae", "2to1", 1));
  const Contrast contrast = read(part_);
  const std::string csv = contrast_csv(contrast);
  EXPECT_THAT(csv, HasSubstr("run,other,vae,10to1,75.0000,0.0000,75.0000,0.0000,2,0.0000,"));
  EXPECT_THAT(csv, HasSubstr("run,other,vae,2to1,85.0000,,85.0000,,1,0.0000,,,,,\n"));
  EXPECT_THAT(contrast.with.gaps,
              testing::ElementsAre(HasSubstr("vae: 10:1 of seeds 0, 1, and 2:1 of seed 0.")));
}

TEST_F(ContrastOfRuns, LeavesOutStaleCellsOfBothSides) {
  EXPECT_THAT(contrast_csv(read(part_, {"seed0/vae", "seed1/vae"})), Not(HasSubstr("vae")));
}

/// A contrast does not need scores.
TEST_F(ContrastOfRuns, DoesNotNeedScores) {
  std::filesystem::remove(layout_.score("vae", 1));
  EXPECT_EQ(read(all_).with.rows.size(), 4U);
}

}  // namespace
}  // namespace piae::report
