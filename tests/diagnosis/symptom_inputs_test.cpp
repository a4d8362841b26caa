#include "diagnosis/symptom_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/training_set.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

/// Rows of a scale, and rows of tested windows.
struct ScaledRows {
  ScaledRows(const signal::WindowSet& normal, const signal::WindowSet& all,
             const signal::WindowSet& tested)
      : scale(normal, all, 0), training(scale.training()), test(scale.rows_of(tested, "--test")) {}
  SymptomScale scale;
  SymptomRows training;
  SymptomRows test;
};

class SymptomRowsOf : public testing::Test {
 protected:
  SymptomRowsOf() {
    Stream stream("inputs");
    add_impact_windows(normal_, 0, 20, stream);
    training_ = normal_;
    for (const Label label : {1, 2}) add_impact_windows(training_, label, 10, stream);
    add_impact_windows(test_, 1, 3, stream);
  }
  signal::WindowSet normal_ = no_impact_windows();
  signal::WindowSet training_ = no_impact_windows();
  signal::WindowSet test_ = no_impact_windows();
};

TEST_F(SymptomRowsOf, AreStandardisedByTheTrainingWindowsAndClipped) {
  const ScaledRows inputs(normal_, training_, test_);
  ASSERT_EQ(inputs.training.rows(), 40);
  ASSERT_EQ(inputs.test.rows(), 3);
  EXPECT_EQ(inputs.scale.labels(), training_.labels);
  EXPECT_LE(inputs.training.cwiseAbs().maxCoeff(), 4);
  for (Eigen::Index symptom = 0; symptom < inputs.training.cols(); ++symptom) {
    const auto column = inputs.training.col(symptom);
    if (column.cwiseAbs().maxCoeff() == 4) continue;
    EXPECT_NEAR(column.mean(), 0, 1e-9) << symptom;
    EXPECT_NEAR(column.squaredNorm() / 40, 1, 1e-3) << symptom;
  }
}

// The largest novelty of a healthy window is 1 / 1.2 if its block is left out. Against a baseline
// that holds the window itself it would be less.
TEST_F(SymptomRowsOf, HealthyWindowsHaveTheNoveltyOfALeftOutBlock) {
  const ScaledRows inputs(normal_, training_, normal_);
  const Eigen::Index novelty = inputs.training.cols() - 1;
  const double left_out = inputs.training.col(novelty).head(20).maxCoeff();
  const double held = inputs.test.col(novelty).maxCoeff();
  EXPECT_GT(left_out, held + 0.05);
  EXPECT_LT((inputs.training.topLeftCorner(20, novelty) - inputs.test.leftCols(novelty))
                .cwiseAbs()
                .maxCoeff(),
            1e-12);
}

/// Sets of a split whose healthy windows have these two speeds, and the others the first of them,
/// which is not that of the data set.
class SymptomRowsAtSpeeds : public testing::Test {
 protected:
  SymptomRowsAtSpeeds() {
    Stream stream("speeds");
    add_impact_windows(normal_, 0, 20, stream);
    for (signal::WindowSet* const set : {&known_, &generated_}) {
      for (const Label label : {1, 2}) add_impact_windows(*set, label, 5, stream);
    }
    known_.shaft_speed_rpm.assign(10, 900);
    healthy_at(900, 900);
  }
  void healthy_at(double rpm, double other_rpm) {
    normal_.shaft_speed_rpm.assign(10, rpm);
    normal_.shaft_speed_rpm.insert(normal_.shaft_speed_rpm.end(), 10, other_rpm);
  }
  /// Expects that windows have the same rows in training as in testing, where each is measured at
  /// its own speed. They start at row `first` of the training.
  void expect_as_tested(const signal::WindowSet& windows, Eigen::Index first) {
    const ScaledRows inputs(normal_, compose_training_set(normal_, known_, &generated_, 5),
                            windows);
    ASSERT_EQ(inputs.training.rows(), 40);
    EXPECT_LT((inputs.training.middleRows(first, 10) - inputs.test).cwiseAbs().maxCoeff(), 1e-12);
  }
  signal::WindowSet normal_ = no_impact_windows();
  signal::WindowSet known_ = no_impact_windows();
  signal::WindowSet generated_ = no_impact_windows();
};

TEST_F(SymptomRowsAtSpeeds, KnownWindowsAreMeasuredAtTheirSpeed) { expect_as_tested(known_, 20); }

TEST_F(SymptomRowsAtSpeeds, GeneratedWindowsAreMeasuredAtTheirSpeedOrTheOnlySpeed) {
  generated_.shaft_speed_rpm.assign(10, 900);
  const signal::WindowSet at_900 = generated_;
  generated_.shaft_speed_rpm.clear();
  expect_as_tested(at_900, 30);
  healthy_at(900, 1200);
  generated_.shaft_speed_rpm = {900, 1200, 900, 1200, 900, 1200, 900, 1200, 900, 1200};
  expect_as_tested(known_, 20);
  expect_as_tested(generated_, 30);
  // They are made from known windows of 900 rpm.
  generated_.shaft_speed_rpm.clear();
  expect_as_tested(at_900, 30);
}

TEST_F(SymptomRowsAtSpeeds, GeneratedWindowsOfAmbiguousSpeedAreRefused) {
  healthy_at(900, 1200);
  known_.shaft_speed_rpm = {900, 1200, 900, 1200, 900, 900, 1200, 900, 1200, 900};
  const signal::WindowSet training = compose_training_set(normal_, known_, &generated_, 5);
  EXPECT_ERROR(ScaledRows(normal_, training, known_), Exit::bad_input,
               "--generated: the windows lack shaft speeds");
}

}  // namespace
}  // namespace piae::diagnosis
