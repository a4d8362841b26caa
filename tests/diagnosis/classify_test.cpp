#include "diagnosis/classify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "diagnosis/nearest.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/sets.hpp"

namespace piae::diagnosis {
namespace {

/// The windows of tones() as recordings give them.
signal::WindowSet recorded_tones(std::size_t per_class, const std::string& stream_name) {
  const LabelledWindows tones_of_classes = tones(per_class, stream_name);
  signal::WindowSet set = empty_set(tones_of_classes.length);
  set.samples = tones_of_classes.samples;
  set.labels = tones_of_classes.labels;
  return set;
}

class Classify : public testing::Test {
 protected:
  [[nodiscard]] WdcnnResult by(const std::string& name) const {
    return classify(the_classifier(name), normal_, training_, test_, {.epochs = 3}, Stream("toy"),
                    make_one_core_backend);
  }

  const signal::WindowSet normal_ = empty_set(1024);  // of which these know nothing
  const signal::WindowSet training_ = recorded_tones(10, "training");
  const signal::WindowSet test_ = recorded_tones(5, "test");
};

TEST_F(Classify, ThePapersIsItsNetworkWithItsRandomNumbers) {
  const WdcnnResult alone = train_and_test(standardise(training_, ""), standardise(test_, ""),
                                           {.epochs = 3}, Stream("toy"), make_one_core_backend);
  EXPECT_EQ(by("wdcnn").outputs.scores, alone.outputs.scores);
}

TEST_F(Classify, AnotherHasRandomNumbersOfItsOwn) {
  const WdcnnResult alone =
      train_and_test(the_classifier("wdcnn-spectrum").represent(training_, ""),
                     the_classifier("wdcnn-spectrum").represent(test_, ""), {.epochs = 3},
                     Stream("toy").child("wdcnn-spectrum"), make_one_core_backend);
  EXPECT_EQ(by("wdcnn-spectrum").outputs.scores, alone.outputs.scores);
}

TEST_F(Classify, TheNearestNeighbourIsAskedWithoutATraining) {
  const WdcnnResult result =
      classify(the_classifier("nearest"), normal_, training_, test_, {}, Stream("toy"), nullptr);
  EXPECT_EQ(result.predictions, test_.labels);
  EXPECT_EQ(result.outputs.scores, scores_of_named(test_.labels, 3));
  EXPECT_TRUE(result.loss.empty());
  EXPECT_EQ(result.training_seconds, 0);
}

TEST_F(Classify, OnlyWdcnnHasTheEpochsOfTheOptions) {
  EXPECT_EQ(epochs_of(the_classifier("wdcnn-envelope"), {.epochs = 3}), 3);
  EXPECT_EQ(epochs_of(the_classifier("symptom-net"), {.epochs = 3}), 60);
  EXPECT_EQ(epochs_of(the_classifier("exclusion-rule"), {.epochs = 3}), 0);
  EXPECT_EQ(epochs_of(the_classifier("nearest"), {.epochs = 3}), 0);
}

}  // namespace
}  // namespace piae::diagnosis
