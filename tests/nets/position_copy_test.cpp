#include "nets/position_copy.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

TEST(PositionCopy, CopiesTheInputToEachPosition) {
  LayerExample example = example_of_shape<PositionCopy<double>>(three_by_sixteen);
  std::vector<double> x(2 * 16);
  x[2] = 7;
  x[16 + 2] = 8;
  const std::vector<double> y = example.forward(x, 2);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_EQ(y[t * 16 + 2], 7);
    EXPECT_EQ(y[(3 + t) * 16 + 2], 8);
  }
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
