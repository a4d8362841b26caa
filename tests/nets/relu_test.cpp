#include "nets/relu.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

TEST(Relu, KeepsPositiveValues) {
  LayerExample example = example_of_shape<Relu<double>>({.length = 1, .width = 16});
  std::vector<double> x(16, -1);
  x[5] = 2;
  const std::vector<double> y = example.forward(x, 1);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(y[i], i == 5 ? 2 : 0);
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
