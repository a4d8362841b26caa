#include "nets/last_position.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

TEST(LastPosition, IsTheLastOfEachWindow) {
  LayerExample example = example_of_shape<LastPosition<double>>({.length = 2, .width = 16});
  std::vector<double> x(2 * 2 * 16);
  x[3] = 5;
  x[16 + 3] = -2;
  x[48 + 3] = 7;
  const std::vector<double> y = example.forward(x, 2);
  EXPECT_EQ(y[3], -2);
  EXPECT_EQ(y[16 + 3], 7);
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
