#include "nets/gradient_array.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "nets/parameter_spec.hpp"

namespace piae::nets {
namespace {

using Kept = Parameters<double>::Kept;

std::shared_ptr<Parameters<double>> two_networks() {
  std::vector<ParameterSpec> specs = dense_specs("a/dense", 2, 3);
  append(specs, dense_specs("ab/dense", 2, 1));
  append(specs, dense_specs("a", 1, 1));
  return std::make_shared<Parameters<double>>(specs, Stream("test"));
}

TEST(GradientArray, HasTheLayoutOfItsParameters) {
  const auto parameters = two_networks();
  GradientArray<double> gradients(parameters, "ab");
  const TrainedParameter<double> weight = gradients.find("dense/weight");
  const TrainedParameter<double> bias = gradients.find("dense/bias");
  EXPECT_EQ(weight.rows, 1);
  EXPECT_EQ(weight.columns, 2);
  EXPECT_EQ(weight.values,
            parameters->data(Kept::value) + parameters->find("ab/dense/weight").begin);
  EXPECT_EQ(bias.gradient - weight.gradient, bias.values - weight.values);
}

TEST(GradientArray, NeedsContiguousParameters) {
  EXPECT_THROW(GradientArray<double>(two_networks(), "a"), std::logic_error);
  EXPECT_THROW(GradientArray<double>(two_networks(), "c"), std::logic_error);
  GradientArray<double> gradients(two_networks(), "ab");
  EXPECT_THROW((void)gradients.find("dense"), std::logic_error);
}

// Adam's first step moves a parameter by the learning rate against its gradient, whatever its size.
TEST(GradientArray, TakesAnAdamStepForItsNetworkOnly) {
  const auto parameters = two_networks();
  const std::vector<float> before = parameters->read(Kept::value);
  GradientArray<double> gradients(parameters, "ab");
  gradients.find("dense/weight").gradient[0] = 3;
  gradients.find("dense/weight").gradient[1] = -4;
  EXPECT_DOUBLE_EQ(gradients.squared_norm(), 25);
  gradients.take(AdamStep(1, 0.5), 0.1);
  const std::vector<float> after = parameters->read(Kept::value);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double moved = i == 9 ? -0.5 : i == 10 ? 0.5 : 0;  // after 6 weights and 3 biases of a
    EXPECT_NEAR(after[i] - before[i], moved, 1e-6) << i;
  }
  EXPECT_NEAR(parameters->data(Kept::first_moment)[parameters->find("ab/dense/weight").begin],
              0.1 * 0.1 * 3, 1e-12);
}

}  // namespace
}  // namespace piae::nets
