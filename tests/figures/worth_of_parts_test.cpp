#include "figures/worth_of_parts.hpp"

#include <fstream>

#include "figures/stored_source.hpp"
#include "report/parts.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class WorthOfParts : public StoredSource {
 protected:
  /// Adds a cell of strike-twin by `nearest`, `right` of 20 windows correct, and a model with the
  /// options of the method itself.
  void add_cell(const std::string& folder, int seed, int right) const {
    artefact::Writer model("model");
    model.save(layout_.model(folder, seed),
               {"train", "edges = \"tested\"\ntilt = \"1.50000000000000001\"\n", {}});
    save("diagnosis", by("nearest", diagnosis("strike-twin", "1to1", 495, seed, right)),
         layout_.diagnosis(folder, "1to1", seed, "nearest"));
  }
  /// Adds a seed: the method classifies `right` windows correctly, four fewer without tilt, ten
  /// fewer with known edges.
  void add_seed(int seed, int right) const {
    add_cell("strike-twin", seed, right);
    add_cell("sweep@strike-twin/tilt-0", seed, right - 4);
    add_cell("sweep@strike-twin/edges-known", seed, right - 10 + seed);
  }
  /// Writes the table of the stage `sweep`.
  void add_table(const std::string& seeds) const {
    const report::Sweep sweep = resolve(report::SweepOptions{.dataset = "cwru",
                                                             .points = {"tilt=0 edges=known"},
                                                             .centre = {},
                                                             .ratios = {"1to1"},
                                                             .seeds = {seeds},
                                                             .method = "strike-twin",
                                                             .classifier = "nearest"});
    run::Results results;
    const auto rows = sweep_rows(layout_, sweep, run::Held(layout_), results);
    std::ofstream(layout_.sweep_csv("strike-twin"))
        << report::parts_csv(sweep, report::part_rows(rows));
  }
  /// Returns the run without requested cells; it has none by the paper's classifier.
  [[nodiscard]] Source looked_at() const {
    const run::Grid nothing{.dataset = "cwru", .scored = {}, .combinations = {}, .seeds = {}};
    return {layout_, nothing, {}};
  }
  /// Returns the numbers of the only picture.
  [[nodiscard]] Numbers numbers() const {
    Source all = looked_at();
    const std::vector<Picture> pictures = worth_of_parts(all);
    EXPECT_EQ(pictures.size(), 1U);
    EXPECT_EQ(pictures.at(0).part, "strike-twin");
    return pictures.at(0).numbers;
  }
};

/// Differences of -50, -45 and -40 points have the deviation 5; Student's t with two degrees of
/// freedom is 4.30265.
TEST_F(WorthOfParts, IsTheDifferenceFromTheMethodForEachSeed) {
  for (const int seed : {0, 1, 2}) add_seed(seed, 16 + seed);
  add_table("0 1 2");
  const Numbers all = numbers();
  EXPECT_EQ(field(all, "tilt=0,1.5,1to1,nearest,1", 5), "-20");
  EXPECT_EQ(field(all, "edges=known,tested,1to1,nearest,0", 5), "-50");
  EXPECT_EQ(field(all, "edges=known,tested,1to1,nearest,mean", 5), "-45");
  EXPECT_EQ(field(all, "edges=known,tested,1to1,nearest,mean", 6), "-57.4207");
  EXPECT_EQ(field(all, "edges=known,tested,1to1,nearest,mean", 7), "-32.5793");
  EXPECT_EQ(field(all, "edges=known,tested,1to1,nearest,mean", 8), "85");
}

/// The order is that of the protocol, and so of the table; it is not alphabetical here.
TEST_F(WorthOfParts, KeepsTheOrderOfTheTable) {
  add_seed(0, 16);
  add_table("0");
  add_seed(1, 16);
  add_cell("sweep@strike-twin/jitter-0", 0, 3);
  const std::string csv = numbers().csv();
  ASSERT_NE(csv.find("\nedges=known,tested,"), std::string::npos);
  EXPECT_LT(csv.find("\ntilt=0,1.5,1to1,nearest,1,"), csv.find("\nedges=known,tested,"));
  EXPECT_EQ(csv.find("jitter"), std::string::npos);
}

TEST_F(WorthOfParts, IsLeftOutWithoutATable) {
  add_seed(0, 16);
  Source one = looked_at();
  EXPECT_THROW(worth_of_parts(one), LeftOut);
}

TEST_F(WorthOfParts, NamesWhatIsMissingOrDamaged) {
  add_seed(0, 16);
  add_table("0");
  Source one = looked_at();
  std::filesystem::remove(layout_.model("strike-twin", 0));
  EXPECT_ERROR(worth_of_parts(one), Exit::input_missing, "seed0/strike-twin/model.h5");
  save("diagnosis", diagnosis("vae", "1to1", 495, 0, 3),
       layout_.diagnosis("sweep@strike-twin/tilt-0", "1to1", 0, "nearest"));
  EXPECT_ERROR(worth_of_parts(one), Exit::bad_input, "sweep@strike-twin/tilt-0/1to1/nearest");
  std::ofstream(layout_.sweep_csv("strike-twin")) << "method,classifier\nstrike-twin,nearest\n";
  EXPECT_ERROR(worth_of_parts(one), Exit::bad_input, "sweep@strike-twin.csv: has no column");
}

}  // namespace
}  // namespace piae::figures
