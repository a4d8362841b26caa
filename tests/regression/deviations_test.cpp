#include "regression/deviations.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "regression/deviations_text.hpp"
#include "run/selection.hpp"

namespace piae::regression {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Adds accuracies of one method at 10to1, for seeds 0, 1, ...
void add(Measurements& side, const std::string& method, const std::vector<double>& values) {
  for (std::size_t seed = 0; seed < values.size(); ++seed) {
    side.values.push_back(
        {method, "wdcnn", "10to1", "accuracy", static_cast<std::int64_t>(seed), values[seed]});
  }
}

Measurements side(const std::vector<double>& values, const std::string& settings = "this machine") {
  Measurements measurements{"cwru", signal::Protocol::random, {}, {"0.1.0"}, {settings}};
  add(measurements, "vae", values);
  return measurements;
}

DeviationRow only_row(const std::vector<double>& reference, const std::vector<double>& run,
                      Tolerance tolerance) {
  const Deviations deviations = find_deviations(side(reference), side(run), {}, tolerance);
  EXPECT_THAT(deviations.missing, IsEmpty());
  EXPECT_THAT(deviations.not_in_reference, IsEmpty());
  EXPECT_EQ(deviations.rows.size(), 1U);
  EXPECT_EQ(deviations.acceptable(), deviations.rows.front().within);
  return deviations.rows.front();
}

/// Returns the number `steps` representable numbers above `value`.
double above(double value, int steps) {
  for (int i = 0; i < steps; ++i) value = std::nextafter(value, 1e9);
  return value;
}

/// Squares about the mean: 0.004 (4 degrees of freedom) and 0.0008 (1): variance 0.0048 / 5. The
/// standard error of the difference of two means of 2 is sqrt(0.00096 (1/2 + 1/2)). 5.51: the
/// Guide to the Expression of Uncertainty in Measurement, Table G.2, 99.73 %.
TEST(Deviations, UseTheSpreadOfAllStoredSeedsForTwoSeeds) {
  const Deviations deviations =
      find_deviations(side({0.60, 0.62, 0.64, 0.66, 0.68}), side({0.60, 0.64}), {.seeds = {0, 1}},
                      Tolerance::spread);
  EXPECT_TRUE(deviations.acceptable());
  ASSERT_EQ(deviations.rows.size(), 1U);
  const DeviationRow& row = deviations.rows.front();
  EXPECT_EQ(row.seeds, 2U);
  EXPECT_EQ(row.moved_seeds, 1U);
  EXPECT_DOUBLE_EQ(row.reference, 0.61);
  EXPECT_DOUBLE_EQ(row.run, 0.62);
  EXPECT_NEAR(*row.standard_error, 0.030983867, 1e-9);
  EXPECT_NEAR(*row.standard_errors(), 0.32274861, 1e-8);
  EXPECT_NEAR(row.allowed, 5.51, 0.005);
}

/// Squares 10 and 10 with 8 degrees of freedom: variance 2.5, standard error sqrt(2.5 * 2 / 5) = 1.
/// 4.28: the same table.
TEST(Deviations, AllowTheStandardErrorsThatChanceExplains) {
  const auto shifted_by = [](double shift) {
    return only_row({1, 2, 3, 4, 5}, {1 + shift, 2 + shift, 3 + shift, 4 + shift, 5 + shift},
                    Tolerance::spread);
  };
  EXPECT_NEAR(*shifted_by(1).standard_errors(), 1, 1e-12);
  EXPECT_NEAR(*shifted_by(-1).standard_errors(), -1, 1e-12);
  EXPECT_NEAR(shifted_by(1).allowed, 4.28, 0.005);
  EXPECT_TRUE(shifted_by(4.27).within);
  EXPECT_TRUE(shifted_by(-4.27).within);
  EXPECT_FALSE(shifted_by(4.29).within);
  EXPECT_FALSE(shifted_by(-4.29).within);
}

/// Few seeds. Squares of `vae`: none (2 degrees of freedom); of `ae`: 2 + 2 (2). Variance together
/// 4 / 4 = 1, of `ae` alone 2. 6.62: the same table.
TEST(Deviations, UseTheSpreadOfOtherRowsForFewSeeds) {
  Measurements reference = side({10, 10});
  Measurements run = side({11, 11});
  add(reference, "ae", {1, 3});
  add(run, "ae", {2, 4});
  const Deviations deviations = find_deviations(reference, run, {}, Tolerance::spread);
  ASSERT_EQ(deviations.rows.size(), 2U);
  EXPECT_NEAR(*deviations.rows[0].standard_error, 1, 1e-12);
  EXPECT_NEAR(*deviations.rows[1].standard_error, std::sqrt(2), 1e-12);
  EXPECT_NEAR(deviations.rows[0].allowed, 6.62, 0.005);
  EXPECT_NEAR(deviations.rows[1].allowed, 6.62, 0.005);
  EXPECT_TRUE(deviations.acceptable());
}

TEST(Deviations, UseTheirOwnSpreadForManySeeds) {
  Measurements reference = side({1, 2, 3, 4, 5});
  Measurements run = side({1, 2, 3, 4, 5});
  add(reference, "ae", {0, 1000});
  add(run, "ae", {0, 1000});
  const Deviations deviations = find_deviations(reference, run, {}, Tolerance::spread);
  EXPECT_NEAR(*deviations.rows.front().standard_error, 1, 1e-12);
}

TEST(Deviations, AllowNoChangeForOneSeed) {
  EXPECT_TRUE(only_row({0.5}, {0.5}, Tolerance::spread).within);
  const DeviationRow moved = only_row({0.5}, {0.501}, Tolerance::spread);
  EXPECT_FALSE(moved.within);
  EXPECT_FALSE(moved.standard_errors());
}

TEST(Deviations, AllowNoChangeWithoutScatter) {
  EXPECT_TRUE(only_row({1, 1, 1}, {1, 1, 1}, Tolerance::spread).within);
  const DeviationRow moved = only_row({1, 1, 1}, {0.99, 0.99, 0.99}, Tolerance::spread);
  EXPECT_FALSE(moved.within);
}

TEST(Deviations, AreExactToFourUnitsInTheLastPlace) {
  EXPECT_TRUE(only_row({0.5, 0.7}, {above(0.5, 4), 0.7}, Tolerance::exact).within);
  const DeviationRow moved = only_row({0.5, 0.7}, {above(0.5, 5), 0.7}, Tolerance::exact);
  EXPECT_FALSE(moved.within);
  EXPECT_EQ(moved.moved_seeds, 1U);
  EXPECT_TRUE(only_row({0.5, 0.7}, {above(0.5, 5), 0.7}, Tolerance::spread).within);
}

/// The means agree, but the seeds do not.
TEST(Deviations, AreExactSeedBySeed) {
  EXPECT_FALSE(only_row({0.5, 0.7}, {0.7, 0.5}, Tolerance::exact).within);
}

TEST(Deviations, AreExactOnlyForEqualSettings) {
  const Measurements here = side({1});
  EXPECT_EQ(tolerance_for(here, side({1})), Tolerance::exact);
  EXPECT_EQ(tolerance_for(here, side({1}, "another machine")), Tolerance::spread);
  Measurements mixed = side({1});
  mixed.settings.insert("another machine");
  EXPECT_EQ(tolerance_for(mixed, mixed), Tolerance::spread);
}

TEST(Deviations, NameCellsOfOneSideOnly) {
  Measurements reference = side({1, 2, 3});
  Measurements run = side({1});
  add(reference, "ae", {1});
  add(run, "smote", {1, 2});
  for (const char* metric : {"mmd", "rmse"}) {
    reference.values.push_back({"ae", "", "", metric, 7, 0.5});
  }
  const Deviations deviations = find_deviations(reference, run, {}, Tolerance::exact);
  EXPECT_THAT(deviations.missing,
              ElementsAre("vae 10to1, seeds 1 2", "ae 10to1, seed 0", "ae score, seed 7"));
  EXPECT_THAT(deviations.not_in_reference, ElementsAre("smote 10to1, seeds 0 1"));
  EXPECT_FALSE(deviations.acceptable());
  EXPECT_TRUE(
      find_deviations(reference, run, {{}, {"vae"}, {}, {0}}, Tolerance::exact).acceptable());
}

// An untrained classifier scatters less. This must not narrow the tolerance for a trained one.
TEST(Deviations, UseTheScatterOfTheirOwnClassifier) {
  const auto with_nearest = [](std::vector<double> values) {
    Measurements both = side({0.60, 0.64, 0.66});
    for (std::size_t seed = 0; seed < values.size(); ++seed) {
      both.values.push_back(
          {"none", "nearest", "100to1", "accuracy", static_cast<std::int64_t>(seed), values[seed]});
    }
    return both;
  };
  const Measurements reference = with_nearest({0.996, 0.996, 0.996});
  EXPECT_EQ(
      *find_deviations(reference, reference, {}, Tolerance::spread).rows[0].standard_error,
      *find_deviations(side({0.60, 0.64, 0.66}), side({0.60, 0.64, 0.66}), {}, Tolerance::spread)
           .rows[0]
           .standard_error);
  Measurements run = with_nearest({0.996, 0.996});
  const Deviations deviations = find_deviations(reference, run, {}, Tolerance::spread);
  EXPECT_THAT(deviations.missing, ElementsAre("none 100to1 by nearest, seed 2"));
  EXPECT_EQ(deviations.rows[1].classifier, "nearest");
}

TEST(Deviations, NeedOneDatasetAndProtocol) {
  Measurements other = side({1});
  other.protocol = signal::Protocol::blocked;
  EXPECT_THROW(find_deviations(side({1}), other, {}, Tolerance::exact), std::logic_error);
}

TEST(Deviations, ShowWhatMoved) {
  Measurements reference = side({0.60, 0.62, 0.64, 0.66, 0.68});
  Measurements run = side({0.70, 0.62, 0.64, 0.66, 0.68}, "another machine");
  add(reference, "ae", {0.5, 0.7});
  add(run, "ae", {0.5, 0.7});
  add(reference, "smote", {0.5});
  const Deviations deviations = find_deviations(reference, run, {}, Tolerance::exact);
  // Squares 0.004 and 0.0004 * 2 + 0.0016 * 2 = 0.004, 8 degrees of freedom: variance 0.001,
  // standard error 0.02.
  EXPECT_EQ(
      deviations_text(reference, run, Tolerance::exact, deviations),
      "cwru, protocol random\n"
      "  reference  0.1.0; this machine\n"
      "  run        0.1.0; another machine\n"
      "  tolerance  exact: every seed must give the same number\n"
      "method  ratio  quantity           seeds  moved  reference   run  difference  std errors  "
      "allowed\n"
      "vae     10to1  accuracy  OUTSIDE      5      1       0.64  0.66       +0.02       +1.00     "
      "4.28\n"
      "missing in the run: smote 10to1, seed 0\n"
      "compared 2 quantities of cwru: 1 moved, 1 outside the tolerance\n");
}

}  // namespace
}  // namespace piae::regression
