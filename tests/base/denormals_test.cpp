#include "base/denormals.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace piae {
namespace {

/// Half of the smallest number with all its digits, computed where the compiler cannot.
float smallest_halved() {
  const volatile float smallest = std::numeric_limits<float>::min();
  return smallest / 2;
}

TEST(FlushDenormals, TakesTooSmallNumbersForZeroAsLongAsItLives) {
  ASSERT_GT(smallest_halved(), 0);
#if defined(__SSE__)
  {
    const FlushDenormals flush;
    EXPECT_EQ(smallest_halved(), 0);
    const volatile float denormal = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(denormal * 1e30F, 0);
  }
  EXPECT_GT(smallest_halved(), 0);
#endif
}

}  // namespace
}  // namespace piae
