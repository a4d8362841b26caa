#include "diagnosis/learn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/train_and_test.hpp"

namespace piae::diagnosis {
namespace {

/// Returns the windows of tones() as a recorded set.
signal::WindowSet recorded_tones(std::size_t per_class, const std::string& stream_name) {
  const LabelledWindows tones_of_classes = tones(per_class, stream_name);
  signal::WindowSet set = empty_set(tones_of_classes.length);
  set.samples = tones_of_classes.samples;
  set.labels = tones_of_classes.labels;
  return set;
}

class Learn : public testing::Test {
 protected:
  [[nodiscard]] Learned by(const std::string& name) const {
    return learn(
        the_classifier(name), normal_, training_,
        {.wdcnn = {.epochs = 3}, .make_backend = make_one_core_backend, .unlabelled = &test_},
        Stream("toy"));
  }
  [[nodiscard]] std::vector<float> scores_by(const std::string& name) const {
    return by(name).trained->outputs(test_, "").scores;
  }
  [[nodiscard]] std::vector<float> alone(const std::string& name, const Stream& stream) const {
    return train_and_test(the_classifier(name).represent(training_, ""),
                          the_classifier(name).represent(test_, ""), {.epochs = 3}, stream,
                          make_one_core_backend)
        .outputs.scores;
  }

  const signal::WindowSet normal_ = empty_set(1024);  // unused by these classifiers
  const signal::WindowSet training_ = recorded_tones(10, "training");
  const signal::WindowSet test_ = recorded_tones(5, "test");
};

TEST_F(Learn, PapersClassifierKeepsItsStream) {
  EXPECT_EQ(scores_by("wdcnn"), alone("wdcnn", Stream("toy")));
}

TEST_F(Learn, OtherClassifiersHaveTheirOwnStream) {
  EXPECT_EQ(scores_by("wdcnn-spectrum"),
            alone("wdcnn-spectrum", Stream("toy").child("wdcnn-spectrum")));
}

TEST_F(Learn, NearestPredictsWithoutTraining) {
  for (const std::string name : {"nearest", "nearest-orders"}) {
    const Learned nearest = by(name);
    EXPECT_EQ(most_likely(nearest.trained->outputs(test_, "").scores, 3), test_.labels) << name;
    EXPECT_TRUE(nearest.training.loss.empty()) << name;
    EXPECT_EQ(nearest.training.seconds, 0) << name;
  }
}

TEST_F(Learn, OnlyWdcnnUsesTheEpochsOption) {
  EXPECT_EQ(epochs_of(the_classifier("wdcnn-envelope"), {.epochs = 3}), 3);
  EXPECT_EQ(epochs_of(the_classifier("wdcnn-orders"), {.epochs = 3}), 3);
  EXPECT_EQ(epochs_of(the_classifier("symptom-net"), {.epochs = 3}), 60);
  EXPECT_EQ(epochs_of(the_classifier("prototypes"), {.epochs = 3}), 50);
  EXPECT_EQ(epochs_of(the_classifier("exclusion-rule"), {.epochs = 3}), 0);
  EXPECT_EQ(epochs_of(the_classifier("nearest"), {.epochs = 3}), 0);
}

}  // namespace
}  // namespace piae::diagnosis
