#pragma once

// Tests of WDCNN's training for every back end. The test of each back end includes these cases and
// instantiates them with its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/train_and_test.hpp"

namespace piae::diagnosis {

inline WdcnnOptions short_training(std::int64_t epochs = 2) {
  WdcnnOptions options;
  options.epochs = epochs;
  options.batch = 8;
  options.learning_rate = 1e-3;
  return options;
}

inline double share_equal(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  double equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i] ? 1 : 0;
  return equal / static_cast<double>(a.size());
}

/// Name of the test, and its back end.
struct TrainedBy {
  const char* name;
  MakeWdcnnBackend backend;
};

inline std::string name_of(const testing::TestParamInfo<TrainedBy>& info) {
  return info.param.name;
}

class WdcnnTraining : public testing::TestWithParam<TrainedBy> {
 protected:
  [[nodiscard]] static const MakeWdcnnBackend& backend() { return GetParam().backend; }
};

TEST_P(WdcnnTraining, LearnsTones) {
  const LabelledWindows test = tones(40, "test");
  const WdcnnResult result =
      train_and_test(tones(30, "train"), test, short_training(12), Stream("learn"), backend());
  EXPECT_GT(share_equal(result.predictions, test.labels), 0.95);
  EXPECT_GT(result.training.train_accuracy.back(), 0.95);
  EXPECT_LT(result.training.loss.back(), 0.2 * result.training.loss.front());
  EXPECT_GT(result.training.seconds, 0);
}

/// The ratio of two scores is exp(a) / exp(b) of their logits.
TEST_P(WdcnnTraining, KeepsTheFeaturesOfEachTestWindow) {
  const LabelledWindows test = tones(35, "test");  // 105 windows: more than one batch
  const Outputs outputs =
      train_and_test(tones(5, "train"), test, short_training(), Stream("layers"), backend())
          .outputs;
  ASSERT_EQ(outputs.hidden.size(), 105U * 100);
  ASSERT_EQ(outputs.logits.size(), 105U * 3);
  for (std::size_t i = 0; i < 105 * 3; i += 3) {
    for (const std::size_t j : {1U, 2U}) {
      EXPECT_NEAR(outputs.scores[i + j] / outputs.scores[i],
                  std::exp(outputs.logits[i + j] - outputs.logits[i]),
                  1e-4 * outputs.scores[i + j] / outputs.scores[i]);
    }
  }
  EXPECT_GE(std::ranges::min(outputs.hidden), 0);  // ReLU
  for (std::size_t i = 0; i < 105; ++i) {
    const auto row = std::span(outputs.hidden).subspan(100 * i, 100);
    EXPECT_GT(std::ranges::max(row), 0) << "of window " << i;
  }
}

TEST_P(WdcnnTraining, ScoresAreProbabilitiesAndPredictionsTheirMaximum) {
  const LabelledWindows test = tones(35, "test");  // 105 windows: more than one batch
  const WdcnnResult result =
      train_and_test(tones(5, "train"), test, short_training(), Stream("scores"), backend());
  ASSERT_EQ(result.predictions.size(), 105U);
  ASSERT_EQ(result.outputs.scores.size(), 105U * 3);
  ASSERT_EQ(result.training.loss.size(), 2U);
  ASSERT_EQ(result.training.train_accuracy.size(), 2U);
  for (std::size_t i = 0; i < 105; ++i) {
    const auto row = result.outputs.scores.begin() + static_cast<std::ptrdiff_t>(3 * i);
    EXPECT_NEAR(std::accumulate(row, row + 3, 0.0), 1.0, 1e-6);
    EXPECT_EQ(std::max_element(row, row + 3) - row, result.predictions[i]);
  }
}

TEST_P(WdcnnTraining, StartsFromTheLossOfAGuess) {
  // The step is too small to learn anything: cross-entropy stays near chance, ln 3.
  WdcnnOptions options = short_training(1);
  options.learning_rate = 1e-12;
  const WdcnnResult result =
      train_and_test(tones(20, "train"), tones(1, "test"), options, Stream("guess"), backend());
  EXPECT_NEAR(result.training.loss[0], std::log(3.0), 0.25);
}

TEST_P(WdcnnTraining, GivesTheSameBitsForTheSameStream) {
  const LabelledWindows train = tones(11, "train");  // 33 windows: the last batch has 9
  const LabelledWindows test = tones(4, "test");
  const auto run = [&](const char* name) {
    return train_and_test(train, test, short_training(), Stream(name), backend());
  };
  const WdcnnResult first = run("a");
  const WdcnnResult other = run("b");
  const WdcnnResult again = run("a");
  EXPECT_EQ(first.outputs.scores, again.outputs.scores);
  EXPECT_EQ(first.training.loss, again.training.loss);
  EXPECT_EQ(first.training.train_accuracy, again.training.train_accuracy);
  EXPECT_NE(first.outputs.scores, other.outputs.scores);
}

TEST_P(WdcnnTraining, EpochsDoNotDependOnTheirNumber) {
  const LabelledWindows train = tones(8, "train");
  const auto loss = [&](std::int64_t epochs) {
    return train_and_test(train, train, short_training(epochs), Stream("a"), backend())
        .training.loss;
  };
  const std::vector<double> three = loss(3);
  EXPECT_EQ(loss(2), std::vector(three.begin(), three.begin() + 2));
}

TEST_P(WdcnnTraining, ReportsEveryEpoch) {
  std::vector<std::int64_t> done;
  std::vector<double> losses;
  const WdcnnResult result =
      train_and_test(tones(3, "train"), tones(1, "test"), short_training(3), Stream("a"), backend(),
                     [&](std::int64_t epoch, double loss) {
                       done.push_back(epoch);
                       losses.push_back(loss);
                     });
  EXPECT_THAT(done, testing::ElementsAre(1, 2, 3));
  EXPECT_EQ(losses, result.training.loss);
}

inline void expect_error(Exit exit, const std::string& part, const LabelledWindows& train,
                         const LabelledWindows& test, const MakeWdcnnBackend& backend,
                         const WdcnnOptions& options = short_training()) {
  try {
    train_and_test(train, test, options, Stream("error"), backend);
    FAIL() << "no error with " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), exit);
    EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST_P(WdcnnTraining, RefusesImpossibleSets) {
  const LabelledWindows good = tones(2, "train");
  LabelledWindows one = good;
  one.labels.resize(1);
  one.samples.resize(1024);
  expect_error(Exit::bad_input, "1 training windows", one, good, backend());

  LabelledWindows none = good;
  none.labels.clear();
  none.samples.clear();
  expect_error(Exit::bad_input, "test windows are missing", good, none, backend());

  LabelledWindows two_long = good;
  two_long.length = 2048;
  two_long.labels.resize(3);
  expect_error(Exit::bad_input, "both must be the same", good, two_long, backend());

  LabelledWindows too_short = good;
  too_short.length = 512;
  too_short.labels.resize(12);
  expect_error(Exit::bad_input, "at least 1024", too_short, too_short, backend());
}

TEST_P(WdcnnTraining, DivergedTrainingNamesTheRemedy) {
  WdcnnOptions options = short_training(20);
  options.learning_rate = 1e30;
  const LabelledWindows train = tones(4, "train");
  expect_error(Exit::failed, "use a smaller", train, train, backend(), options);
}

}  // namespace piae::diagnosis
