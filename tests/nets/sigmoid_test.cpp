// Compares the vector functions with the C library's in long double.

#include "nets/sigmoid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace piae::nets {
namespace {

template <class T>
class GateFunctions : public testing::Test {
 protected:
  using Exact = std::function<long double(long double)>;
  using Mine = std::function<Vector<T>(Vector<T>)>;

  static T first_of(Vector<T> vector) {
    T numbers[lanes<T>];
    store<T>(numbers, vector);
    for (const T x : numbers) EXPECT_EQ(x, numbers[0]);
    return numbers[0];
  }
  static T at(const Mine& mine, T x) { return first_of(mine(Vector<T>{} + x)); }

  /// Returns the largest relative error between -limit and limit, in units of the last place of 1.
  static long double largest_error(const Mine& mine, const Exact& exact, double limit) {
    long double largest = 0;
    for (int i = -200'000; i <= 200'000; ++i) {
      const double fraction = i / 200'000.0;
      // Dense around zero, where relative errors are hard to keep small.
      const T x = static_cast<T>(limit * fraction * fraction * fraction);
      if (x == 0) continue;
      const long double expected = exact(x);
      const long double error = std::abs((at(mine, x) - expected) / expected);
      largest = std::max(largest, error / std::numeric_limits<T>::epsilon());
    }
    return largest;
  }
  static Vector<T> logistic(Vector<T> x) { return sigmoid<T>(x); }
  static Vector<T> tangent(Vector<T> x) { return nets::tanh<T>(x); }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(GateFunctions, Precisions);

TYPED_TEST(GateFunctions, AreExactToAFewUnitsInTheLastPlace) {
  using Of = GateFunctions<TypeParam>;
  const auto sigmoid_of = [](long double x) { return 1 / (1 + std::exp(-x)); };
  const auto tanh_of = [](long double x) { return std::tanh(x); };
  EXPECT_LT(Of::largest_error(&Of::logistic, sigmoid_of, 80), 3);
  EXPECT_LT(Of::largest_error(&Of::tangent, tanh_of, 30), 3);
}

TYPED_TEST(GateFunctions, ReachTheirLimitsFarFromZero) {
  using Of = GateFunctions<TypeParam>;
  constexpr TypeParam far = std::numeric_limits<TypeParam>::max();
  EXPECT_EQ(Of::at(&Of::logistic, far), 1);
  EXPECT_GT(Of::at(&Of::logistic, -far), 0);
  EXPECT_LT(Of::at(&Of::logistic, -far), 1e-37);
  EXPECT_TRUE(std::isnormal(Of::at(&Of::logistic, -far)));
  EXPECT_EQ(Of::at(&Of::tangent, far), 1);
  EXPECT_EQ(Of::at(&Of::tangent, -far), -1);
  EXPECT_EQ(Of::at(&Of::logistic, 0), 0.5);
  EXPECT_EQ(Of::at(&Of::tangent, 0), 0);
}

// The NaN in the loss reveals a training that diverges.
TYPED_TEST(GateFunctions, PropagateNan) {
  using Of = GateFunctions<TypeParam>;
  constexpr TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_TRUE(std::isnan(Of::logistic(Vector<TypeParam>{} + nan)[0]));
  EXPECT_TRUE(std::isnan(Of::tangent(Vector<TypeParam>{} + nan)[0]));
}

}  // namespace
}  // namespace piae::nets
