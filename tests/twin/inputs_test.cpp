#include "twin/inputs.hpp"

#include <gtest/gtest.h>

#include "nets/torch.hpp"

namespace piae::twin {
namespace {

TEST(Inputs, PointsAreRows) {
  const torch::Tensor rows = as_tensor({{1.5, 2.5}, {3.5, 4.5}, {5.5, 6.5}}, torch::kCPU);
  EXPECT_TRUE(rows.equal(torch::tensor({{1.5F, 2.5F}, {3.5F, 4.5F}, {5.5F, 6.5F}})));
}

TEST(Inputs, OneClassForAllWindows) {
  const torch::Tensor rows = one_hot_of(2, 4, 3, torch::kCPU);
  EXPECT_TRUE(
      rows.equal(torch::tensor({{0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}}).to(torch::kFloat32)));
}

}  // namespace
}  // namespace piae::twin
