#include "diagnosis/nearest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "support/errors.hpp"
#include "support/three_classes.hpp"

namespace piae::diagnosis {
namespace {

/// Makes windows that ring at a frequency of their class, each with its own angle and level.
signal::WindowSet ringing(const std::string& stream_name, int of_each, std::size_t length = 1024) {
  Stream stream(stream_name);
  signal::WindowSet windows;
  windows.info = three_classes("example");
  windows.length = length;
  for (int label = 0; label < 3; ++label) {
    for (int i = 0; i < of_each; ++i) {
      const double phase = stream.uniform(0, 2 * std::numbers::pi);
      const double level = stream.uniform(0.1, 10);
      for (std::size_t t = 0; t < length; ++t) {
        const double ring = std::sin((0.5 + 0.3 * label) * static_cast<double>(t) + phase);
        windows.samples.push_back(static_cast<float>(level * (ring + stream.normal(0, 0.3)) + 5));
      }
      windows.labels.push_back(label);
    }
  }
  return windows;
}

std::vector<Label> named_by(const signal::WindowSet& training, const signal::WindowSet& test) {
  return most_likely(Nearest(training).outputs(test, "--test").scores, 3);
}

TEST(Nearest, DistinguishesSpectraAtAnyAngleAndLevel) {
  const signal::WindowSet test = ringing("test", 20);
  EXPECT_EQ(named_by(ringing("training", 1), test), test.labels);
}

TEST(Nearest, FindsATrainingWindowItself) {
  signal::WindowSet training = ringing("training", 4);
  for (std::size_t i = 0; i < training.size(); ++i) training.labels[i] = static_cast<Label>(i % 3);
  EXPECT_EQ(named_by(training, training), training.labels);
}

TEST(Nearest, SilentWindowsGiveFiniteDistances) {
  signal::WindowSet silent = ringing("test", 1);
  std::ranges::fill(silent.samples, 0.0F);
  EXPECT_EQ(named_by(ringing("training", 2), silent).size(), 3U);
}

// The distance of a window to itself is 0; that to the nearest of another class is d.
TEST(Nearest, ScoresThePredictedClassOnlyAndHasHalfSquaredDistancesAsLogits) {
  const signal::WindowSet training = ringing("training", 2);
  const Outputs outputs = Nearest(training).outputs(training, "");
  const FeatureRows bands = band_powers(training);
  EXPECT_EQ(std::vector<float>(outputs.scores.begin(), outputs.scores.begin() + 3),
            (std::vector<float>{1, 0, 0}));
  EXPECT_NEAR(outputs.logits[0], 0, 1e-6);
  const double to_second = std::min((bands.row(0) - bands.row(2)).squaredNorm(),
                                    (bands.row(0) - bands.row(3)).squaredNorm());
  EXPECT_NEAR(outputs.logits[1], -to_second / 2, 1e-5 * to_second);
}

TEST(Nearest, NeverPredictsAClassWithoutWindows) {
  signal::WindowSet training = ringing("training", 1);
  training.labels[2] = 0;
  const Outputs outputs = Nearest(training).outputs(training, "");
  EXPECT_LT(outputs.logits[2], -1e5);
}

TEST(Nearest, NeedsTwoBinsPerBandAndEqualLengths) {
  EXPECT_ERROR(named_by(ringing("a", 1, 255), ringing("b", 1, 255)), Exit::bad_input,
               "windows of 255 samples");
  EXPECT_ERROR(named_by(ringing("a", 1, 512), ringing("b", 1, 256)), Exit::bad_input,
               "both must be the same");
}

}  // namespace
}  // namespace piae::diagnosis
