#include "nets/parameter_spec.hpp"

#include <gtest/gtest.h>

namespace piae::nets {
namespace {

TEST(DenseChainSpecs, ListsLayersInOrderWithTheWidthBetween) {
  const auto specs = dense_chain_specs("net/a", 7, 2, {3, 5});
  ASSERT_EQ(specs.size(), 6U);
  const std::vector<std::vector<std::int64_t>> shapes{{5, 7}, {5}, {5, 5}, {5}, {2, 5}, {2}};
  for (std::size_t i = 0; i < specs.size(); ++i) EXPECT_EQ(specs[i].shape, shapes[i]) << i;
  EXPECT_EQ(specs[0].name, "net/a/0/weight");
  EXPECT_EQ(specs[5].name, "net/a/2/bias");
}

TEST(DenseChainSpecs, OneLayerIsLinear) {
  const auto specs = dense_chain_specs("net/a", 7, 2, {1, 5});
  ASSERT_EQ(specs.size(), 2U);
  EXPECT_EQ(specs[0].shape, (std::vector<std::int64_t>{2, 7}));
}

}  // namespace
}  // namespace piae::nets
