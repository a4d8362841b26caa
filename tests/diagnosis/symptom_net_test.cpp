#include "diagnosis/symptom_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

class SymptomNetOfToys : public testing::Test {
 protected:
  SymptomNetOfToys() {
    Stream stream("net");
    add_impact_windows(normal_, 0, 40, stream);
    training_ = normal_;
    // Impacts in training have a higher level, as those of another machine might.
    for (const Label label : {1, 2}) add_impact_windows(training_, label, 20, stream, 14);
    for (const Label label : {0, 1, 2}) add_impact_windows(test_, label, 20, stream, 9);
  }
  [[nodiscard]] Learned trained(const std::string& stream) const {
    return train_symptom_net(normal_, training_, 0, Stream(stream));
  }
  [[nodiscard]] Outputs outputs_of(const Learned& learned) const {
    return learned.trained->outputs(test_, "--test");
  }
  signal::WindowSet normal_ = no_impact_windows();
  signal::WindowSet training_ = no_impact_windows();
  signal::WindowSet test_ = no_impact_windows();
};

TEST_F(SymptomNetOfToys, LearnsToPredictTheDefectiveElement) {
  const Learned learned = trained("toy");
  const Outputs outputs = outputs_of(learned);
  const std::vector<Label> named = most_likely(outputs.scores, 3);
  EXPECT_EQ(named, test_.labels);
  const Training& training = learned.training;
  ASSERT_EQ(training.loss.size(), 60U);
  ASSERT_EQ(training.train_accuracy.size(), 60U);
  EXPECT_LT(training.loss.back(), training.loss.front() / 4);
  EXPECT_GT(training.train_accuracy.back(), 0.97);
  EXPECT_GT(training.seconds, 0);
  EXPECT_EQ(outputs.hidden.size(), 60U * 48);
  EXPECT_EQ(outputs.logits.size(), 60U * 3);
  for (std::size_t i = 0; i < 60; ++i) {
    const auto row = std::span(outputs.scores).subspan(3 * i, 3);
    EXPECT_NEAR(row[0] + row[1] + row[2], 1, 1e-6);
  }
}

TEST_F(SymptomNetOfToys, IsReproducibleForAStream) {
  const std::vector<float> once = outputs_of(trained("toy")).scores;
  EXPECT_EQ(outputs_of(trained("toy")).scores, once);
  EXPECT_NE(outputs_of(trained("other")).scores, once);
}

TEST_F(SymptomNetOfToys, ReportsEachEpoch) {
  std::vector<std::int64_t> epochs;
  (void)train_symptom_net(normal_, training_, 0, Stream("toy"),
                          [&](std::int64_t done, double) { epochs.push_back(done); });
  ASSERT_EQ(epochs.size(), 60U);
  EXPECT_EQ(epochs.front(), 1);
  EXPECT_EQ(epochs.back(), 60);
}

}  // namespace
}  // namespace piae::diagnosis
