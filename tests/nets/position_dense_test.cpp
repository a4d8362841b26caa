#include "nets/position_dense.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

LayerExample dense_at_positions(std::int64_t inputs, std::int64_t outputs, std::int64_t length) {
  return LayerExample(
      [&](GradientArray<double>& parameters) {
        return std::make_unique<PositionDense<double>>(parameters, "dense", length);
      },
      dense_specs("net/dense", inputs, outputs));
}

TEST(PositionDense, IsADenseLayerAtEachPosition) {
  LayerExample example = dense_at_positions(2, 1, 2);
  example.parameters->write(Parameters<double>::Kept::value, std::vector<float>{2, -1, 0.5F});
  std::vector<double> x(2 * 16);
  x[0] = 3;
  x[1] = 1;
  x[16] = -1;
  const std::vector<double> y = example.forward(x, 1);
  EXPECT_EQ(y[0], 2 * 3 - 1 + 0.5);
  EXPECT_EQ(y[16], 2 * -1 + 0.5);
  EXPECT_EQ(y[1], 0);  // padding of the row
}

TEST(PositionDense, HasTheGradientsOfFiniteDifferences) {
  LayerExample whole = dense_at_positions(16, 32, 2);
  expect_gradients_of_differences(whole, 3);
}

TEST(PositionDense, HasNoBiasUnlessRequested) {
  LayerExample example(
      [](GradientArray<double>& parameters) {
        return std::make_unique<PositionDense<double>>(parameters, "dense", 2, Bias::absent);
      },
      {unbiased_dense_spec("net/dense", 16, 32)});
  EXPECT_EQ(example.forward(std::vector<double>(3 * 2 * 16), 3), std::vector<double>(3 * 2 * 32));
  expect_gradients_of_differences(example, 3);
}

// The padding of the input is zero.
TEST(PositionDense, GradientsOfNarrowRowsExcludeThePadding) {
  LayerExample example = dense_at_positions(3, 2, 1);
  std::vector<double> x(2 * 16);
  for (const std::size_t i : {0, 1, 2, 16, 17, 18}) x[i] = 0.5 * static_cast<double>(i) - 3;
  std::vector<double> slope(2 * 16);
  slope[0] = 2;
  slope[17] = 3;
  std::vector<double> by_x(2 * 16);
  example.forward(x, 2);
  example.layer->backward({.windows = 2, .signals = 1}, x.data(), slope.data(), by_x.data());
  const TrainedParameter<double> weight = example.gradients.find("dense/weight");
  for (std::int64_t j = 0; j < 16; ++j) {
    const auto at = static_cast<std::size_t>(j);
    EXPECT_DOUBLE_EQ(weight.gradient[j], 2 * x[at]);
    EXPECT_DOUBLE_EQ(weight.gradient[16 + j], 3 * x[16 + at]);
    EXPECT_DOUBLE_EQ(by_x[at], 2 * weight.values[j]);
    EXPECT_DOUBLE_EQ(by_x[16 + at], 3 * weight.values[16 + j]);
  }
}

}  // namespace
}  // namespace piae::nets
