#include "base/vector.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/random.hpp"

namespace piae {
namespace {

/// Compares one vector of roots with those of the standard library, bit for bit.
void expect_roots(const std::array<double, lanes<double>>& numbers) {
  std::array<double, lanes<double>> roots{};
  store<double>(roots.data(), positive_root(load(numbers.data())));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(roots[i], std::sqrt(numbers[i])) << numbers[i];
  }
}

TEST(PositiveRoot, IsRoundedLikeTheStandardLibrary) {
  Stream random("roots");
  std::array<double, lanes<double>> numbers{};
  for (int i = 0; i < 20000; ++i) {
    for (double& x : numbers) x = std::ldexp(random.uniform(1, 4), static_cast<int>(i % 600) - 500);
    expect_roots(numbers);
  }
}

TEST(PositiveRoot, IsRoundedLikeTheStandardLibraryNearSquares) {
  Stream random("squares");
  std::array<double, lanes<double>> numbers{};
  for (int i = 0; i < 20000; ++i) {
    for (double& x : numbers) {
      const double root = random.uniform(1, 2);
      x = std::nextafter(root * root, i % 2 == 0 ? 0 : 10);
    }
    expect_roots(numbers);
  }
}

TEST(PositiveRoot, IsZeroForOtherNumbers) {
  for (const double x : {0.0, -1e-300, -4.0}) {
    double roots[lanes<double>];
    store<double>(roots, positive_root(Vector<double>{} + x));
    for (const double root : roots) EXPECT_EQ(root, 0) << x;
  }
}

TEST(AnyPositive, ChecksEachNumber) {
  EXPECT_FALSE(any_positive(Vector<double>{}));
  EXPECT_FALSE(any_positive(Vector<double>{} - 1));
  for (std::int64_t i = 0; i < lanes<double>; ++i) {
    Vector<double> x{};
    x[i] = 1e-300;
    EXPECT_TRUE(any_positive(x)) << i;
  }
}

}  // namespace
}  // namespace piae
