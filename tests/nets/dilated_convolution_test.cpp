#include "nets/dilated_convolution.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

LayerExample convolution(std::int64_t length, const DilatedTaps& taps, std::int64_t inputs = 16,
                         std::int64_t outputs = 16) {
  return LayerExample(
      [&](GradientArray<double>& parameters) {
        return std::make_unique<DilatedConvolution<double>>(parameters, "conv", length, taps);
      },
      dilated_convolution_specs("net/conv", inputs, outputs, taps.kernel));
}

/// Only the first channel has weights: 1, 10 and 100 for the taps, and a bias of 0.5.
TEST(DilatedConvolution, ReadsDilatedPositionsOnBothSidesAndZerosBeyondTheEnds) {
  LayerExample example = convolution(5, {.kernel = 3, .dilation = 2});
  std::vector<float> values(16 * 3 * 16 + 16);
  for (const std::size_t tap : {0, 1, 2}) values[tap * 16] = tap == 0 ? 1 : tap == 1 ? 10 : 100;
  values[16 * 3 * 16] = 0.5F;
  example.parameters->write(Parameters<double>::Kept::value, values);
  std::vector<double> x(2 * 5 * 16);
  for (std::size_t t = 0; t < 10; ++t) x[t * 16] = static_cast<double>(t + 1);  // 1..5, 6..10
  const std::vector<double> y = example.forward(x, 2);
  const double expected[] = {
      10 * 1 + 100 * 3, 10 * 2 + 100 * 4, 1 + 10 * 3 + 100 * 5,  2 + 10 * 4, 3 + 10 * 5,
      10 * 6 + 100 * 8, 10 * 7 + 100 * 9, 6 + 10 * 8 + 100 * 10, 7 + 10 * 9, 8 + 10 * 10};
  for (std::size_t t = 0; t < 10; ++t) {
    EXPECT_EQ(y[t * 16], expected[t] + 0.5) << t;
    EXPECT_EQ(y[t * 16 + 1], 0) << t;
  }
}

TEST(DilatedConvolution, HasTheGradientsOfFiniteDifferences) {
  for (const std::int64_t dilation : {1, 2, 7}) {  // the last reaches beyond both ends
    LayerExample example = convolution(6, {.kernel = 3, .dilation = dilation});
    expect_gradients_of_differences(example, 2);
  }
  LayerExample wide = convolution(6, {.kernel = 5, .dilation = 1}, 16, 32);
  expect_gradients_of_differences(wide, 1);
}

TEST(DilatedConvolution, NeedsChannelsThatFillWholeRows) {
  EXPECT_THROW(convolution(4, {.kernel = 3, .dilation = 1}, 15), std::logic_error);
  EXPECT_THROW(convolution(4, {.kernel = 3, .dilation = 1}, 16, 17), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
