#include "augment/line_minimum.hpp"

#include <gtest/gtest.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

namespace piae::augment {
namespace {

/// Expects that both evaluate the function at the same points, in order, and find the same minimum.
template <class F>
void expect_as_boost(const F& f, int bits, int most_values) {
  std::vector<double> by_boost;
  const auto noted = [&](double x) {
    by_boost.push_back(x);
    return f(x);
  };
  auto count = static_cast<std::uintmax_t>(most_values);
  const double found = boost::math::tools::brent_find_minima(noted, -1.0, 2.0, bits, count).first;

  LineMinimum line(-1, 2, bits, most_values);
  std::vector<double> ours;
  while (!line.done()) {
    ours.push_back(line.next());
    line.take(f(line.next()));
  }
  ASSERT_EQ(ours.size(), by_boost.size());
  for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i], by_boost[i], 1e-12) << i;
  EXPECT_NEAR(line.best(), found, 1e-12);
}

TEST(LineMinimum, EvaluatesTheSamePointsAsBoost) {
  for (const int most_values : {1, 5, 30}) {
    expect_as_boost([](double x) { return (x - 0.3) * (x - 0.3); }, 12, most_values);
    expect_as_boost([](double x) { return std::cosh(x + 0.4) + 0.3 * x; }, 12, most_values);
    expect_as_boost([](double x) { return std::abs(x - 1.9); }, 8, most_values);
    expect_as_boost([](double x) { return std::sin(7 * x) + x; }, 10, most_values);
    expect_as_boost([](double /*x*/) { return 1.0; }, 6, most_values);
    // The third point is the vertex, from which the next step would be zero.
    expect_as_boost([](double x) { return (x - 1.5) * (x - 1.5); }, 12, most_values);
  }
}

}  // namespace
}  // namespace piae::augment
