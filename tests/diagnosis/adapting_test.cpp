#include "diagnosis/adapting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "diagnosis/learn.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/wdcnn_inputs.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;

constexpr std::int32_t taught = 0;  ///< the condition of the labelled faults
constexpr std::int32_t tested = 1;

/// Makes windows of one condition: every class has a tone of its own. In the tested condition the
/// path to the sensor also passes the tone of another machine, 20 times as strong.
WindowSet recorded(std::int32_t condition, std::size_t per_class, const std::string& name) {
  WindowSet set = empty_set(1024);
  set.info.conditions = {{.name = "taught", .shaft_speed_rpm = 1800, .test = false},
                         {.name = "tested", .shaft_speed_rpm = 1800, .known = false}};
  Stream stream(name);
  for (std::size_t i = 0; i < 3 * per_class; ++i) {
    const auto label = static_cast<Label>(i % 3);
    const double own = 20.0 * (label + 1);
    const double strength = condition == taught ? 0 : 20;
    const double phases[] = {stream.uniform(0, 2 * std::numbers::pi),
                             stream.uniform(0, 2 * std::numbers::pi)};
    for (std::size_t t = 0; t < set.length; ++t) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(t) / 1024;
      set.samples.push_back(static_cast<float>(std::sin(own * turn + phases[0]) +
                                               strength * std::sin(340 * turn + phases[1]) +
                                               stream.normal(0, 0.3)));
    }
    set.labels.push_back(label);
    set.condition.push_back(condition);
    set.shaft_speed_rpm.push_back(1800);
  }
  return set;
}

class Adapting : public testing::Test {
 protected:
  [[nodiscard]] std::vector<float> scores_by(const Classifier& classifier,
                                             const std::string& stream = "toy") const {
    return learn(classifier, normal_, training_,
                 {.wdcnn = {.epochs = 20, .batch = 16, .learning_rate = 1e-3},
                  .make_backend = make_one_core_backend,
                  .unlabelled = &hidden_},
                 Stream(stream))
        .trained->outputs(test_, "")
        .scores;
  }
  /// Returns the accuracy of the network on spectra, as the mean of three trainings.
  [[nodiscard]] double accuracy_with(Adaptation adaptation) const {
    Classifier classifier = wdcnn_spectra;
    classifier.adaptation = adaptation;
    double correct = 0;
    for (const char* stream : {"a", "b", "c"}) {
      const std::vector<Label> predictions = most_likely(scores_by(classifier, stream), 3);
      for (std::size_t i = 0; i < predictions.size(); ++i) {
        correct += predictions[i] == test_.labels[i] ? 1 : 0;
      }
    }
    return correct / static_cast<double>(3 * test_.size());
  }

  const WindowSet normal_ = recorded(taught, 2, "normal");
  const WindowSet training_ = recorded(taught, 100, "training");
  WindowSet hidden_ = recorded(tested, 100, "hidden");
  const WindowSet test_ = recorded(tested, 50, "test");
};

// Guessing gives a third.
TEST_F(Adapting, SucceedsWhereTheSameNetworkFails) {
  EXPECT_LT(accuracy_with(Adaptation::none), 0.7);
  EXPECT_GT(accuracy_with(Adaptation::marginal), 0.85);
  EXPECT_GT(accuracy_with(Adaptation::conditional), 0.85);
}

TEST_F(Adapting, DoesNotUseTheLabels) {
  const std::vector<float> scores = scores_by(cdan);
  std::ranges::fill(hidden_.labels, hidden_.labels.front());
  EXPECT_EQ(scores_by(cdan), scores);
}

TEST_F(Adapting, TakesHealthyWindowsOfTheTestedConditionOnly) {
  EXPECT_EQ(without_labels(normal_, hidden_).size(), hidden_.size());
  const WindowSet there = recorded(tested, 2, "normal");
  EXPECT_EQ(without_labels(there, hidden_).size(), hidden_.size() + there.size());
  WindowSet everywhere = normal_;
  std::ranges::fill(everywhere.condition, signal::every_condition);
  EXPECT_EQ(without_labels(everywhere, hidden_).size(), hidden_.size() + normal_.size());
  const WindowSet plain = empty_set(1024);
  WindowSet some = plain;
  add(some, 0, 3, 1);
  EXPECT_EQ(without_labels(some, plain).size(), 3U);
  EXPECT_EQ(without_labels(there, hidden_).count_of(0), hidden_.size() + there.size());
}

}  // namespace
}  // namespace piae::diagnosis
