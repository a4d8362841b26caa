#include "nets/residual.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"
#include "nets/relu.hpp"

namespace piae::nets {
namespace {

TEST(Residual, AddsItsInput) {
  LayerExample example([](GradientArray<double>&) {
    return std::make_unique<Residual<double>>(std::make_unique<Relu<double>>(three_by_sixteen));
  });
  EXPECT_EQ(example.forward(std::vector<double>(48, 2), 1), std::vector<double>(48, 4));
  EXPECT_EQ(example.forward(std::vector<double>(48, -2), 1), std::vector<double>(48, -2));
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
