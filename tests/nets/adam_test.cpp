#include "nets/adam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace piae::nets {
namespace {

template <class T>
class AdamOf : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(AdamOf, Precisions, );

// Algorithm 1 of Kingma and Ba, written out for one parameter, beta 0.9 and 0.999.
TYPED_TEST(AdamOf, OneParameterTakesTheHandWorkedSteps) {
  const double tolerance = std::is_same_v<TypeParam, float> ? 2e-7 : 1e-8;
  Adam<TypeParam> adam(1);
  TypeParam value = 1;
  const auto step = [&](double gradient, double rate) {
    const auto g = static_cast<TypeParam>(gradient);
    adam.step(&value, &g, rate);
  };
  step(0.5, 0.1);  // m = 0.05, v = 0.00025; corrected 0.5 and 0.25: 1 - 0.1 * 0.5 / 0.5
  EXPECT_NEAR(value, 0.9, tolerance);

  step(-1.0, 0.1);  // m = -0.055, v = 0.00124975; corrected -0.2894737 and 0.6251876
  const double second = 0.9 + 0.1 * (0.055 / 0.19) / std::sqrt(0.00124975 / 0.001999);
  EXPECT_NEAR(value, second, tolerance);
  EXPECT_NEAR(value, 0.93661035, 2e-7);

  step(2.0, 0.01);  // m = 0.1505, v = 0.00524850025; 1 - beta^3: 0.271 and 0.002997001
  const double third = second - 0.01 * (0.1505 / 0.271) / std::sqrt(0.00524850025 / 0.002997001);
  EXPECT_NEAR(value, third, tolerance);
}

// More parameters than fill the vectors of any processor, each with its own gradient.
TYPED_TEST(AdamOf, EachParameterTakesItsOwnSteps) {
  constexpr std::size_t size = 77;
  std::vector<TypeParam> together(size, 1);
  Adam<TypeParam> all(size);
  std::vector<TypeParam> gradients(size);
  const auto gradient_of = [](std::size_t i, int t) {
    return static_cast<TypeParam>(std::cos(0.7 * static_cast<double>(i) + t));
  };
  for (int t = 0; t < 4; ++t) {
    for (std::size_t i = 0; i < size; ++i) gradients[i] = gradient_of(i, t);
    all.step(together.data(), gradients.data(), 0.01);
  }
  for (std::size_t i = 0; i < size; ++i) {
    TypeParam alone = 1;
    Adam<TypeParam> one(1);
    for (int t = 0; t < 4; ++t) {
      const TypeParam gradient = gradient_of(i, t);
      one.step(&alone, &gradient, 0.01);
    }
    EXPECT_NEAR(together[i], alone, 1e-6) << i;
  }
}

TYPED_TEST(AdamOf, ParameterWithoutAGradientDoesNotMove) {
  Adam<TypeParam> adam(1);
  TypeParam value = 3;
  const TypeParam nothing = 0;
  for (int t = 0; t < 3; ++t) adam.step(&value, &nothing, 0.1);
  EXPECT_EQ(value, 3);
}

// The corrections of the first step reduce a gradient g to g / |g|, for all constants.
TYPED_TEST(AdamOf, FirstStepHasTheLengthOfTheLearningRate) {
  for (const double beta1 : {0.5, 0.9}) {
    TypeParam value = 0;
    TypeParam first_moment = 0;
    TypeParam second_moment = 0;
    AdamUpdate<TypeParam>(AdamStep(1, 0.01, beta1, 0.9))(TypeParam{-7}, value, first_moment,
                                                         second_moment);
    EXPECT_NEAR(value, 0.01, 1e-8);
    EXPECT_NEAR(first_moment, -7 * (1 - beta1), 1e-6);
    EXPECT_NEAR(second_moment, 4.9, 1e-6);
  }
}

// A moment must not stay denormal, which is a hundred times slower: nine tenths of the smallest
// denormal numbers round to themselves.
TYPED_TEST(AdamOf, AMomentFadesToZero) {
#if !defined(__SSE__)
  GTEST_SKIP() << "this processor keeps denormal numbers";
#endif
  TypeParam value = 1;
  TypeParam first_moment = 1;
  TypeParam second_moment = 1;
  const TypeParam none = 0;
  for (int t = 1; t < 9000; ++t) {
    take(AdamStep(t, 1e-3), &value, &none, &first_moment, &second_moment, 1);
  }
  EXPECT_EQ(first_moment, 0);
}

}  // namespace
}  // namespace piae::nets
