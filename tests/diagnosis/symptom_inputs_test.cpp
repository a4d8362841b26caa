#include "diagnosis/symptom_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/struck_windows.hpp"

namespace piae::diagnosis {
namespace {

class SymptomRowsOf : public testing::Test {
 protected:
  SymptomRowsOf() {
    Stream stream("inputs");
    add_struck(normal_, 0, 20, stream);
    training_ = normal_;
    for (const Label label : {1, 2}) add_struck(training_, label, 10, stream);
    add_struck(test_, 1, 3, stream);
  }
  signal::WindowSet normal_ = no_struck_windows();
  signal::WindowSet training_ = no_struck_windows();
  signal::WindowSet test_ = no_struck_windows();
};

TEST_F(SymptomRowsOf, AreStandardisedByTheTrainingWindowsAndClipped) {
  const SymptomInputs inputs = symptom_inputs(normal_, training_, test_);
  ASSERT_EQ(inputs.training.rows(), 40);
  ASSERT_EQ(inputs.test.rows(), 3);
  EXPECT_EQ(inputs.labels, training_.labels);
  EXPECT_LE(inputs.training.cwiseAbs().maxCoeff(), 4);
  for (Eigen::Index symptom = 0; symptom < inputs.training.cols(); ++symptom) {
    const auto column = inputs.training.col(symptom);
    if (column.cwiseAbs().maxCoeff() == 4) continue;
    EXPECT_NEAR(column.mean(), 0, 1e-9) << symptom;
    EXPECT_NEAR(column.squaredNorm() / 40, 1, 1e-3) << symptom;
  }
}

// The largest novelty of a healthy window is 1 / 1.2 when its block is left out. It would be less
// against a baseline that holds the window itself.
TEST_F(SymptomRowsOf, HaveOfHealthyWindowsTheNoveltyOfABlockThatIsLeftOut) {
  const SymptomInputs inputs = symptom_inputs(normal_, training_, normal_);
  const Eigen::Index novelty = inputs.training.cols() - 1;
  const double left_out = inputs.training.col(novelty).head(20).maxCoeff();
  const double held = inputs.test.col(novelty).maxCoeff();
  EXPECT_GT(left_out, held + 0.05);
  EXPECT_LT((inputs.training.topLeftCorner(20, novelty) - inputs.test.leftCols(novelty))
                .cwiseAbs()
                .maxCoeff(),
            1e-12);
}

}  // namespace
}  // namespace piae::diagnosis
