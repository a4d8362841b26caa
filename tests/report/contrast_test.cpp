#include "report/contrast.hpp"

#include "base/error.hpp"
#include "report/accuracy_rows.hpp"
#include "report/ratio_columns.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;

/// With the overlap: none 70 and 80, vae 90 and 94 at 10to1. Without: 60 and 60, 90 and 90.
Contrast two_protocols() {
  const std::vector<AccuracyRow> with{row_with("none", "100to1", {70, 80}),
                                      row_with("vae", "10to1", {90, 94})};
  const std::vector<AccuracyRow> without{row_with("none", "100to1", {60, 60}),
                                         row_with("vae", "10to1", {90, 90})};
  return contrast({"results/a", "cwru", signal::Protocol::random, with_means(with)},
                  {"results/a-blocked", "cwru", signal::Protocol::blocked, with_means(without)});
}

const std::string header =
    "with,without,method,ratio,with_mean,with_std,without_mean,without_std,seeds,mean_difference,"
    "ci95_low,ci95_high,rank_biserial,p,p_holm\n";

/// Of two values a, b the deviation is |a - b| / sqrt(2), and the interval's half 12.7062 |a - b|
/// / 2. Of four signs two are as extreme; of two, without the zero, both.
TEST(Contrast, IsThatWorkedByHand) {
  EXPECT_EQ(
      contrast_csv(two_protocols()),
      header +
          "random,blocked,none,100to1,75.0000,7.0711,60.0000,0.0000,2,15.0000,-48.5310,78.5310,"
          "1.0000,0.5,0.5\n"
          "random,blocked,vae,10to1,92.0000,2.8284,90.0000,0.0000,2,2.0000,-23.4124,27.4124,"
          "1.0000,1,1\n");
}

TEST(Contrast, HasBothSidesAboveTheirDifference) {
  const std::string text = markdown(contrast_document(two_protocols()));
  EXPECT_THAT(text, HasSubstr("# cwru: random against blocked\n\nWhat random is worth:"));
  EXPECT_THAT(text, HasSubstr("| method |            |            100:1 |             10:1 |\n"
                              "|--------|------------|-----------------:|-----------------:|\n"
                              "| none   | random     |     75.00 ± 7.07 |                  |\n"
                              "|        | blocked    |     60.00 ± 0.00 |                  |\n"
                              "|        | difference |    +15.00 ± 7.07 |                  |\n"
                              "|        | 95 %       | [-48.53, +78.53] |                  |\n"
                              "|        | effect     |            +1.00 |                  |\n"
                              "|        | p (Holm)   |        0.5 (0.5) |                  |\n"
                              "| vae    | random     |                  |     92.00 ± 2.83 |\n"
                              "|        | blocked    |                  |     90.00 ± 0.00 |\n"
                              "|        | difference |                  |     +2.00 ± 2.83 |\n"
                              "|        | 95 %       |                  | [-23.41, +27.41] |\n"
                              "|        | effect     |                  |            +1.00 |\n"
                              "|        | p (Holm)   |                  |            1 (1) |\n"));
}

TEST(Contrast, NamesItsSidesByWhatDiffers) {
  const Side side{
      "results/a", "cwru", signal::Protocol::random, {row_with("none", "100to1", {70})}};
  Side other = side;
  other.dataset = "cwru-as-published";
  EXPECT_EQ(contrast_csv(contrast(other, side)),
            header + "cwru-as-published,cwru,none,100to1,70.0000,,70.0000,,1,0.0000,,,,,\n");
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

class SideOfARun : public StoredRun {
 protected:
  [[nodiscard]] Side read(const std::string& folder) const {
    return read_side(folder, {"", {"none vae"}, {"100to1 10to1 2to1"}, {"0 1"}});
  }
};

TEST_F(SideOfARun, HasItsCellsAndTheirMean) {
  add_all();
  for (const char* end : {"", "/"}) {
    const Side side = read((folder_.path() / "run" / "cwru").string() + end);
    EXPECT_EQ(side.dataset, "cwru");
    EXPECT_EQ(side.protocol, signal::Protocol::random);
    EXPECT_EQ(side.run.filename(), "run");
    ASSERT_EQ(side.rows.size(), 4U);
    EXPECT_EQ(side.rows.back().ratio, mean_of_ratios);
    EXPECT_THAT(side.rows.back().values, testing::ElementsAre(80, 85));
  }
}

TEST_F(SideOfARun, WithoutACellIsRefused) {
  add_all();
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 1));
  try {
    FAIL() << "took a run with a hole: " << read(folder_.path() / "run" / "cwru").rows.size();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::input_missing);
  }
}

/// A score is not needed for it.
TEST_F(SideOfARun, NeedsNoScores) {
  add_all();
  std::filesystem::remove(layout_.score("vae", 1));
  EXPECT_EQ(read(folder_.path() / "run" / "cwru").rows.size(), 4U);
}

}  // namespace
}  // namespace piae::report
