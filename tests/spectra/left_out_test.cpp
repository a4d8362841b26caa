#include "spectra/left_out.hpp"

#include <gtest/gtest.h>

namespace piae::spectra {
namespace {

TEST(LeftOut, BlocksHaveEqualSizeInTimeOrder) {
  const int blocks[] = {0, 0, 0, 1, 1, 2, 2, 2, 3, 3};  // i * 4 / 10
  for (int i = 0; i < 10; ++i) EXPECT_EQ(block_of(i, 10, 4), blocks[i]) << i;
}

TEST(LeftOut, ThresholdHasAMarginAndIsNotZero) {
  EXPECT_DOUBLE_EQ(left_out_threshold(5, 1.2, 1e-6), 6);
  EXPECT_EQ(left_out_threshold(0, 1.2, 1e-6), 1e-6);
}

}  // namespace
}  // namespace piae::spectra
