#include "nets/position_mean.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

TEST(PositionMean, IsTheMeanOverThePositions) {
  LayerExample example = example_of_shape<PositionMean<double>>({.length = 2, .width = 16});
  std::vector<double> x(2 * 16);
  x[3] = 5;
  x[16 + 3] = -2;
  EXPECT_EQ(example.forward(x, 1)[3], 1.5);
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
