#include "scoring/temperature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace piae::scoring {
namespace {

TEST(Tempered, IsTheSoftmaxOfLogitsByTheTemperature) {
  // exp(ln 9 / 2) = 3; the second row has an offset of 100.
  const auto nine = static_cast<float>(std::log(9.0));
  const std::vector<float> logits{nine, 0, 0, 100, 100 + nine, 100};
  const std::vector<float> expected{0.6F, 0.2F, 0.2F, 0.2F, 0.6F, 0.2F};
  const std::vector<float> probabilities = tempered(logits, 3, 2);
  ASSERT_EQ(probabilities.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(probabilities[i], expected[i], 1e-5);
}

TEST(Tempered, IsFiniteForDistantLogits) {
  const std::vector<float> sure = tempered(std::vector<float>{0, -1e6F, -3e38F}, 3, 0.02);
  EXPECT_EQ(sure, (std::vector<float>{1, 0, 0}));
}

/// Windows of two classes with the classifier's logits.
struct Judged {
  std::vector<float> logits;
  std::vector<Label> labels;

  void add(int count, Label named, Label label, double logit) {
    for (int i = 0; i < count; ++i) {
      for (const Label each : {0, 1}) {
        logits.push_back(each == named ? static_cast<float>(logit) : 0.0F);
      }
      labels.push_back(label);
    }
  }
  [[nodiscard]] double temperature() const { return best_temperature(logits, labels, 2); }
};

/// Returns windows of which three of four are predicted correctly in both classes.
Judged right_three_times_of_four(int quarters, double logit) {
  Judged judged;
  for (const Label named : {0, 1}) {
    judged.add(3 * quarters, named, named, logit);
    judged.add(quarters, named, 1 - named, logit);
  }
  return judged;
}

// The logit of 3 to 1 is ln 3; a logit `factor` times larger needs that temperature. With 80 000
// windows the probability (n + 1) / (n + 2) hardly matters.
TEST(BestTemperature, IsTheFactorByWhichLogitsAreTooLarge) {
  for (const double factor : {0.25, 1.0, 2.0, 10.0}) {
    const Judged judged = right_three_times_of_four(10000, factor * std::log(3.0));
    EXPECT_NEAR(judged.temperature(), factor, 1e-3 * factor) << factor;
  }
}

// If all n windows are correct, the mean is least for a softmax of (n + 1) / (n + 2): the logit
// divided by the temperature is ln(n + 1).
TEST(BestTemperature, IsBoundByTheNumberOfWindowsIfAllAreCorrect) {
  for (const int each : {4, 50}) {
    Judged judged;
    judged.add(each, 0, 0, 6);
    judged.add(each, 1, 1, 6);
    EXPECT_NEAR(judged.temperature(), 6 / std::log(2.0 * each + 1), 2e-3) << each;
  }
}

// Class 0 is correct three times of four, class 1 always: each class has half the weight, however
// many windows it has.
TEST(BestTemperature, WeighsClassesEqually) {
  const auto with_so_many_of_class_1 = [](int count) {
    Judged judged;
    judged.add(30000, 0, 0, 2);
    judged.add(10000, 1, 0, 2);
    judged.add(count, 1, 1, 2);
    return judged.temperature();
  };
  // Correct with weight 7/8: ln 7 = 2 / T.
  EXPECT_NEAR(with_so_many_of_class_1(40000), 2 / std::log(7.0), 1e-3);
  EXPECT_NEAR(with_so_many_of_class_1(400), with_so_many_of_class_1(40000), 1e-3);
}

// Wrong logits need an infinite temperature, and underconfident ones a temperature near 0.
TEST(BestTemperature, StaysBetweenAFiftiethAndFifty) {
  Judged wrong;
  wrong.add(10, 0, 1, 5);
  wrong.add(10, 1, 0, 5);
  EXPECT_NEAR(wrong.temperature(), 50, 0.1);
  Judged timid;
  timid.add(10, 0, 0, 1e-6);
  timid.add(10, 1, 1, 1e-6);
  EXPECT_NEAR(timid.temperature(), 0.02, 1e-4);
}

TEST(BestTemperature, NeedsLabels) {
  EXPECT_THROW((void)best_temperature({}, {}, 2), std::logic_error);
}

}  // namespace
}  // namespace piae::scoring
