#include "diagnosis/symptom_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/struck_windows.hpp"

namespace piae::diagnosis {
namespace {

class SymptomNet : public testing::Test {
 protected:
  SymptomNet() {
    Stream stream("net");
    add_struck(normal_, 0, 40, stream);
    training_ = normal_;
    // The strikes it learns from are louder, as those of another machine might be.
    for (const Label label : {1, 2}) add_struck(training_, label, 20, stream, 14);
    for (const Label label : {0, 1, 2}) add_struck(test_, label, 20, stream, 9);
  }
  [[nodiscard]] WdcnnResult trained(const std::string& stream) const {
    return train_and_test_symptoms(normal_, training_, test_, Stream(stream));
  }
  signal::WindowSet normal_ = no_struck_windows();
  signal::WindowSet training_ = no_struck_windows();
  signal::WindowSet test_ = no_struck_windows();
};

TEST_F(SymptomNet, LearnsToNameWhatIsStruck) {
  const WdcnnResult result = trained("toy");
  EXPECT_EQ(result.predictions, test_.labels);
  ASSERT_EQ(result.loss.size(), 60U);
  ASSERT_EQ(result.train_accuracy.size(), 60U);
  EXPECT_LT(result.loss.back(), result.loss.front() / 4);
  EXPECT_GT(result.train_accuracy.back(), 0.97);
  EXPECT_GT(result.training_seconds, 0);
  EXPECT_EQ(result.outputs.hidden.size(), 60U * 48);
  EXPECT_EQ(result.outputs.logits.size(), 60U * 3);
  for (std::size_t i = 0; i < 60; ++i) {
    const auto row = std::span(result.outputs.scores).subspan(3 * i, 3);
    EXPECT_NEAR(row[0] + row[1] + row[2], 1, 1e-6);
    EXPECT_EQ(std::ranges::max_element(row) - row.begin(), result.predictions[i]);
  }
}

TEST_F(SymptomNet, IsTheSameOfTheSameStreamAndAnotherOfAnother) {
  const WdcnnResult once = trained("toy");
  EXPECT_EQ(trained("toy").outputs.scores, once.outputs.scores);
  EXPECT_NE(trained("other").outputs.scores, once.outputs.scores);
}

TEST_F(SymptomNet, TellsOfEachEpoch) {
  std::vector<std::int64_t> epochs;
  (void)train_and_test_symptoms(normal_, training_, test_, Stream("toy"),
                                [&](std::int64_t done, double) { epochs.push_back(done); });
  ASSERT_EQ(epochs.size(), 60U);
  EXPECT_EQ(epochs.front(), 1);
  EXPECT_EQ(epochs.back(), 60);
}

}  // namespace
}  // namespace piae::diagnosis
