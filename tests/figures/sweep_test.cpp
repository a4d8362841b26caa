#include "figures/sweep.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class SweepFigure : public StoredSource {
 protected:
  /// Adds a model of piae-dt with these options, and its diagnosis with `right` of 20 windows
  /// correct.
  void add_cell(const std::string& folder, const std::string& options, int seed, int right) const {
    artefact::Writer model("model");
    model.save(layout_.model(folder, seed), {"train", options, {}});
    save("diagnosis", diagnosis("piae-dt", "1to1", 495, seed, right),
         layout_.diagnosis(folder, "1to1", seed));
  }
  /// Adds a sweep with batches of 2 and 10, a learning rate, and other loss weights.
  void add_sweep(int seed, int right) const {
    const std::string rate = "learning-rate = \"0.00050000000000000001\"\n";
    const std::string weights = "loss-weights = \"adaptive\"\n";
    const std::string batch = "batch = \"5\"\n";
    add_cell("piae-dt", batch + rate + weights, seed, right);
    add_cell("sweep/batch-10", "batch = \"10\"\n" + rate + weights, seed, right + 1);
    add_cell("sweep/batch-2", "batch = \"2\"\n" + rate + weights, seed, right - 1);
    add_cell("sweep/learning-rate-1e-4", batch + "learning-rate = \"0.0001\"\n" + weights, seed,
             right + 2);
    add_cell("sweep/loss-weights-adaptive-without-log",
             batch + rate + "loss-weights = \"adaptive-without-log\"\n", seed, right + 3);
  }
  [[nodiscard]] Source swept(const std::string& seeds) const {
    return source("piae-dt", "1to1", seeds);
  }
};

TEST_F(SweepFigure, SortsTheValuesOfEachFactor) {
  add_sweep(0, 10);
  Source one = swept("0");
  const Numbers numbers = sweeps(one);
  EXPECT_EQ(field(numbers, "batch,1,2,0,1to1,0", 6), "45");
  EXPECT_EQ(field(numbers, "batch,2,5,1,1to1,0", 6), "50");
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,0", 6), "55");
  EXPECT_EQ(field(numbers, "learning-rate,1,0.0001,0,1to1,0", 6), "60");
  EXPECT_EQ(field(numbers, "learning-rate,2,0.0005,1,1to1,0", 6), "50");
  EXPECT_EQ(field(numbers, "loss-weights,1,adaptive,1,1to1,0", 6), "50");
  EXPECT_EQ(field(numbers, "loss-weights,2,adaptive-without-log,0,1to1,0", 6), "65");
}

TEST_F(SweepFigure, HasTheFactorsInTheOrderOfThePaper) {
  add_sweep(0, 10);
  Source one = swept("0");
  const std::string csv = sweeps(one).csv();
  ASSERT_NE(csv.find("\nlearning-rate,"), std::string::npos);
  EXPECT_LT(csv.find("\nbatch,"), csv.find("\nloss-weights,"));
  EXPECT_LT(csv.find("\nloss-weights,"), csv.find("\nlearning-rate,"));
}

TEST_F(SweepFigure, HasMeanAndIntervalOverTheSeedsThatHaveASweep) {
  for (const int seed : {0, 1, 2}) add_sweep(seed, 10 + seed);
  Source four = swept("0 1 2 3");
  const Numbers numbers = sweeps(four);
  // 60 -+ 4.30265 * 5 / sqrt(3), Student's t with two degrees of freedom.
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,mean", 6), "60");
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,mean", 7), "47.5793");
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,mean", 8), "72.4207");
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,3", 6), "no row");
}

/// Such a folder remains from a time when the grid had another value.
TEST_F(SweepFigure, HasTheValueOfTheGridOnce) {
  add_sweep(0, 10);
  add_cell("sweep/batch-5", "batch = \"5\"\n", 0, 3);
  Source one = swept("0");
  const Numbers numbers = sweeps(one);
  EXPECT_EQ(field(numbers, "batch,2,5,1,1to1,0", 6), "50");
  EXPECT_EQ(field(numbers, "batch,3,10,0,1to1,0", 6), "55");
}

TEST_F(SweepFigure, IsLeftOutWithoutASweep) {
  add_cell("piae-dt", "batch = \"5\"\n", 0, 10);
  Source one = swept("0");
  EXPECT_THROW(sweeps(one), LeftOut);
}

TEST_F(SweepFigure, NamesAMissingCell) {
  add_sweep(0, 10);
  add_sweep(1, 10);
  std::filesystem::remove(layout_.diagnosis("sweep/batch-10", "1to1", 1));
  Source two = swept("0 1");
  EXPECT_ERROR(sweeps(two), Exit::input_missing, "seed1/sweep/batch-10/1to1/wdcnn/diagnosis.h5");
  std::filesystem::remove(layout_.model("sweep/batch-2", 0));
  EXPECT_ERROR(sweeps(two), Exit::input_missing, "seed0/sweep/batch-2/model.h5");
}

TEST_F(SweepFigure, RefusesAModelThatContradictsItsFolder) {
  add_sweep(0, 10);
  add_cell("sweep/batch-7", "batch = \"8\"\n", 0, 10);
  Source one = swept("0");
  EXPECT_ERROR(sweeps(one), Exit::bad_input, "sweep/batch-7/model.h5");
}

}  // namespace
}  // namespace piae::figures
