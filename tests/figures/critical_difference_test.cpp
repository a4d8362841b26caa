#include "figures/critical_difference.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

class CriticalDifference : public StoredSource {
 protected:
  /// Adds seeds in which shift is the best, then piae-dt, then none.
  void add_seeds(int seeds) const {
    for (int seed = 0; seed < seeds; ++seed) {
      add(diagnosis("none", "100to1", 0, seed, 10));
      add(diagnosis("piae-dt", "10to1", 45, seed, 12));
      add(diagnosis("shift", "10to1", 45, seed, 14));
      add(diagnosis("oracle", "10to1", 45, seed, 20));
    }
  }
  [[nodiscard]] Numbers numbers_of(const std::string& seeds) const {
    Source all = source("none piae-dt shift oracle", "100to1 10to1", seeds);
    return critical_differences(all, all.accuracies().front());
  }
};

/// By hand: the same order of three, five times, gives p = 1 / 6^4; the difference is 2.3437
/// sqrt(12 / 30).
TEST_F(CriticalDifference, ListsTheBestMethodFirstAndTheTest) {
  add_seeds(5);
  const Numbers numbers = numbers_of("0 1 2 3 4");
  EXPECT_EQ(field(numbers, "10to1,method,shift", 3), "1");
  EXPECT_EQ(field(numbers, "10to1,method,shift", 4), "1");
  EXPECT_EQ(field(numbers, "10to1,method,none", 3), "3");
  EXPECT_EQ(field(numbers, "10to1,method,none", 4), "3");
  EXPECT_EQ(field(numbers, "10to1,method,none", 6), "5");
  EXPECT_EQ(field(numbers, "10to1,method,none", 7), "0.000771605");
  EXPECT_EQ(field(numbers, "10to1,method,none", 8).substr(0, 6), "1.4822");
}

/// Neighbours are one rank apart, the ends two, more than 1.48.
TEST_F(CriticalDifference, JoinsMethodsWithinTheCriticalDifference) {
  add_seeds(5);
  const Numbers numbers = numbers_of("0 1 2 3 4");
  EXPECT_EQ(field(numbers, "10to1,alike,,1", 4), "1");
  EXPECT_EQ(field(numbers, "10to1,alike,,1", 5), "2");
  EXPECT_EQ(field(numbers, "10to1,alike,,2", 4), "2");
  EXPECT_EQ(field(numbers, "10to1,alike,,2", 5), "3");
  EXPECT_EQ(field(numbers, "10to1,alike,,3", 4), "no row");
}

/// Two seeds: the difference is 2.34, more than the distance between the ends.
TEST_F(CriticalDifference, HasOneBarIfAllMethodsAreEqual) {
  add_seeds(2);
  const Numbers numbers = numbers_of("0 1");
  EXPECT_EQ(field(numbers, "10to1,alike,,1", 4), "1");
  EXPECT_EQ(field(numbers, "10to1,alike,,1", 5), "3");
  EXPECT_EQ(field(numbers, "10to1,alike,,2", 4), "no row");
}

TEST_F(CriticalDifference, HasNoTestForOneSeed) {
  add_seeds(1);
  const Numbers numbers = numbers_of("0");
  EXPECT_EQ(field(numbers, "10to1,method,none", 7), "");
  EXPECT_THAT(numbers.csv(), Not(HasSubstr("alike")));
}

TEST_F(CriticalDifference, DoesNotRankACeiling) {
  add_seeds(2);
  EXPECT_THAT(numbers_of("0 1").csv(), Not(HasSubstr("oracle")));
}

TEST_F(CriticalDifference, IsLeftOutWithLessThanTwoMethods) {
  add(diagnosis("piae-dt", "10to1", 45, 0, 12));
  add(diagnosis("oracle", "10to1", 45, 0, 18));
  Source one = source("piae-dt oracle", "10to1", "0");
  EXPECT_THROW(critical_differences(one, one.accuracies().front()), LeftOut);
}

TEST_F(CriticalDifference, NamesTheFirstMissingCell) {
  add_seeds(1);
  EXPECT_ERROR(numbers_of("0 1"), Exit::input_missing, "method none, ratio 100to1, seed 1");
}

}  // namespace
}  // namespace piae::figures
