#include "figures/paired_differences.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class PairedDifferences : public StoredSource {
 protected:
  /// Adds three seeds: against piae-dt with 75 percent, vae has 5, 10 and 15 points more, and none
  /// 15 less.
  void add_three_seeds() const {
    for (const int seed : {0, 1, 2}) {
      add(diagnosis("none", "100to1", 0, seed, 12));
      add(diagnosis("vae", "10to1", 45, seed, 16 + seed));
      add(diagnosis("piae-dt", "10to1", 45, seed, 15));
    }
  }
};

TEST_F(PairedDifferences, AreThoseOfTheSameSeedWithTheirInterval) {
  add_three_seeds();
  Source three = source("none vae piae-dt", "100to1 10to1", "0 1 2");
  const Numbers numbers = paired_differences(three, three.accuracies().front());
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,0", 5), "5");
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,2", 5), "15");
  EXPECT_EQ(field(numbers, "none,0,10to1,piae-dt,1", 5), "-15");
  // 10 -+ 4.30265 * 5 / sqrt(3), Student's t with two degrees of freedom.
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 5), "10");
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 6), "-2.42069");
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 7), "22.4207");
}

/// Three differences of the same sign: p is 2 / 2^3, the least for three seeds, and Holm doubles
/// the smaller one of two.
TEST_F(PairedDifferences, ShowPAndItsSmallestPossibleValue) {
  add_three_seeds();
  Source three = source("none vae piae-dt", "100to1 10to1", "0 1 2");
  const Numbers numbers = paired_differences(three, three.accuracies().front());
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 8), "0.25");
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 9), "0.5");
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 10), "0.5");
}

TEST_F(PairedDifferences, ExcludeTheCeilingFromTheCorrection) {
  add_three_seeds();
  for (const int seed : {0, 1, 2}) add(diagnosis("oracle", "10to1", 45, seed, 19));
  Source three = source("none vae piae-dt oracle", "100to1 10to1", "0 1 2");
  const Numbers numbers = paired_differences(three, three.accuracies().front());
  EXPECT_EQ(field(numbers, "vae,0,10to1,piae-dt,mean", 9), "0.5");
  EXPECT_EQ(field(numbers, "oracle,1,10to1,piae-dt,mean", 8), "0.25");
  EXPECT_EQ(field(numbers, "oracle,1,10to1,piae-dt,mean", 9), "");
  EXPECT_EQ(field(numbers, "oracle,1,10to1,piae-dt,mean", 10), "0.25");
}

TEST_F(PairedDifferences, HaveNoIntervalAndNoPForTooFewSeeds) {
  add(diagnosis("vae", "10to1", 45, 0, 15));
  add(diagnosis("piae-dt", "10to1", 45, 0, 14));
  Source one = source("vae piae-dt", "10to1", "0");
  EXPECT_EQ(field(paired_differences(one, one.accuracies().front()), "vae,0,10to1,piae-dt,mean", 5),
            "5");
  EXPECT_EQ(field(paired_differences(one, one.accuracies().front()), "vae,0,10to1,piae-dt,mean", 9),
            "");
  add(diagnosis("vae", "10to1", 45, 1, 15));
  add(diagnosis("piae-dt", "10to1", 45, 1, 14));
  Source two = source("vae piae-dt", "10to1", "0 1");
  EXPECT_EQ(field(paired_differences(two, two.accuracies().front()), "vae,0,10to1,piae-dt,mean", 6),
            "");
  EXPECT_EQ(field(paired_differences(two, two.accuracies().front()), "vae,0,10to1,piae-dt,mean", 9),
            "0.5");
}

TEST_F(PairedDifferences, IncludeTheMeanOfTheRatios) {
  add_method("vae");  // 75 and 75 at 10to1, 85 and 95 at 2to1
  for (const int seed : {0, 1}) {
    add(diagnosis("piae-dt", "10to1", 45, seed, 14));
    add(diagnosis("piae-dt", "2to1", 145, seed, 16));
  }
  Source two = source("vae piae-dt", "10to1 2to1");
  EXPECT_EQ(field(paired_differences(two, two.accuracies().front()), "vae,0,mean,piae-dt,0", 5),
            "5");
  EXPECT_EQ(field(paired_differences(two, two.accuracies().front()), "vae,0,mean,piae-dt,mean", 5),
            "7.5");
}

TEST_F(PairedDifferences, AreLeftOutWithoutAMethodToCompareWith) {
  add_all();
  Source all = source("none vae", "100to1 10to1");
  EXPECT_THROW(paired_differences(all, all.accuracies().front()), LeftOut);
}

TEST_F(PairedDifferences, NameTheFirstMissingCell) {
  add_three_seeds();
  Source four = source("none vae piae-dt", "100to1 10to1", "0 1 2 3");
  EXPECT_ERROR(paired_differences(four, four.accuracies().front()), Exit::input_missing,
               "method none, ratio 100to1, seed 3");
}

}  // namespace
}  // namespace piae::figures
