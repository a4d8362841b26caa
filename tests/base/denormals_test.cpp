#include "base/denormals.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace piae {
namespace {

TEST(DenormalsAreZero, HoldsDuringItsLifetime) {
  volatile float smallest = std::numeric_limits<float>::min();
  volatile float denormal = smallest / 4;
  ASSERT_GT(denormal, 0);
#if !defined(__SSE__)
  GTEST_SKIP() << "this processor keeps them";
#endif
  // Compared later, because the guard also treats denormal numbers as zero in comparisons.
  volatile float computed = 1;
  volatile float read = 1;
  volatile float normal = 0;
  {
    const DenormalsAreZero guard;
    computed = smallest / 4;
    read = denormal * 8;
    normal = smallest * 3;
  }
  EXPECT_EQ(computed, 0);
  EXPECT_EQ(read, 0);
  EXPECT_EQ(normal / 3, smallest);
  volatile float after = smallest / 4;
  EXPECT_EQ(after, denormal);
}

}  // namespace
}  // namespace piae
