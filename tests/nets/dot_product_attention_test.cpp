#include "nets/dot_product_attention.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

LayerExample attention(std::int64_t length, std::int64_t width, std::int64_t heads) {
  return LayerExample([&](GradientArray<double>&) {
    return std::make_unique<DotProductAttention<double>>(
        SequenceShape{.length = length, .width = width}, heads);
  });
}

// Two positions, two heads of 8. In the first head, the query of position 0 is 4 along number 0,
// and the keys are 0 and 1 there: scores 0 and 4 / sqrt(8). In the second head all queries are 0,
// so both positions have equal weight.
TEST(DotProductAttention, WeighsValuesByTheSoftmaxOfItsScoresHeadByHead) {
  LayerExample example = attention(2, 16, 2);
  std::vector<double> x(2 * 48);
  x[0] = 4;        // query of position 0, first head
  x[48 + 16] = 1;  // key of position 1, first head
  x[32] = 2;       // values of number 0: 2 and 6
  x[48 + 32] = 6;
  x[32 + 8] = -1;  // values of number 8, of the second head: -1 and 5
  x[48 + 32 + 8] = 5;
  const std::vector<double> y = example.forward(x, 1);
  const double second = std::exp(std::sqrt(2.0)) / (1 + std::exp(std::sqrt(2.0)));
  EXPECT_NEAR(y[0], 2 + 4 * second, 1e-12);
  EXPECT_NEAR(y[16], 4, 1e-12);  // the query of position 1 is 0
  EXPECT_NEAR(y[8], 2, 1e-12);
  EXPECT_NEAR(y[16 + 8], 2, 1e-12);
}

TEST(DotProductAttention, IsFiniteForAnyScores) {
  LayerExample example = attention(2, 16, 2);
  std::vector<double> x(2 * 48, 1e4);
  for (const double y : example.forward(x, 1)) EXPECT_NEAR(y, 1e4, 1e-8);
}

TEST(DotProductAttention, HasTheGradientsOfFiniteDifferences) {
  for (const std::int64_t heads : {1, 4}) {
    LayerExample example = attention(3, 16, heads);
    expect_gradients_of_differences(example, 2);
  }
}

TEST(DotProductAttention, NeedsAWidthThatItsHeadsDivide) {
  EXPECT_THROW(attention(3, 16, 3), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
