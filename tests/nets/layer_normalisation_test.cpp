#include "nets/layer_normalisation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

LayerExample normalisation(std::int64_t length, std::int64_t width) {
  return LayerExample(
      [&](GradientArray<double>& parameters) {
        return std::make_unique<LayerNormalisation<double>>(parameters, "norm", length);
      },
      layer_normalisation_specs("net/norm", width));
}

// Eight numbers at 3 and eight at 7: mean 5, variance 4.
TEST(LayerNormalisation, StartsWithMeanZeroAndVarianceOne) {
  LayerExample example = normalisation(2, 16);
  std::vector<double> x(2 * 16);
  for (std::size_t i = 0; i < 16; ++i) {
    x[i] = i % 2 == 0 ? 3 : 7;
    x[16 + i] = 100 * x[i];
  }
  const std::vector<double> y = example.forward(x, 1);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(y[i], (i % 2 == 0 ? -2 : 2) / std::sqrt(4 + 1e-5), 1e-12);
    EXPECT_NEAR(y[16 + i], y[i], 1e-5);
  }
}

TEST(LayerNormalisation, HasTheGradientsOfFiniteDifferences) {
  LayerExample example = normalisation(3, 16);
  std::vector<float> values;
  for (const double x : random_numbers("scale and shift", 32)) {
    values.push_back(static_cast<float>(x));
  }
  example.parameters->write(Parameters<double>::Kept::value, values);
  expect_gradients_of_differences(example, 2);
}

TEST(LayerNormalisation, NeedsAWidthThatFillsWholeRows) {
  EXPECT_THROW(normalisation(3, 12), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
