// Compares whole steps of our back end with LibTorch's from the same parameters.

#include "twin/one_core_backend.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libtorch/twin/backend.hpp"
#include "support/gradients.hpp"
#include "twin/example_task.hpp"

namespace piae::twin {
namespace {

/// Returns the gradient of the first and only step: ten times Adam's first moment.
std::vector<float> gradient_of(const TwinBackend& backend, const std::string& group) {
  return piae::first_moments([&](artefact::Writer& writer) { backend.write_adam(writer, "/adam"); },
                             "/adam/" + group);
}

constexpr LearningRates rates{.networks = 1e-3, .loss_weights = 2e-2};

class TwinAgainstLibtorch : public testing::TestWithParam<TaskOf> {};

// Uses single precision. LibTorch computes the distances of eq. 21's MMD from products, which
// leaves five digits.
TEST_P(TwinAgainstLibtorch, StepsLikeLibtorch) {
  const TwinTask task = task_of(GetParam());
  const std::vector<std::size_t> batch{7, 2, 5, 0, 8};
  for (const TrainingStage stage : {TrainingStage::one, TrainingStage::two}) {
    const auto mine = one_core_engine(Device::cpu).train(task, Stream("initial"));
    const auto theirs = libtorch::twin_engine(Device::cpu).train(task, Stream("initial"));
    ASSERT_EQ(values_of(*mine), values_of(*theirs));
    const BatchLosses own = mine->step(stage, batch, rates);
    const BatchLosses other = theirs->step(stage, batch, rates);
    EXPECT_NEAR(own.reconstruction, other.reconstruction, 1e-5 * other.reconstruction);
    EXPECT_NEAR(own.differential, other.differential, 1e-5 * other.differential);
    EXPECT_NEAR(own.twin, other.twin, 1e-4 * other.twin);
    EXPECT_NEAR(own.total, other.total, 1e-5 * std::abs(other.total));
    for (const std::string group : {"networks", "loss_weights"}) {
      EXPECT_LT(relative_difference(gradient_of(*mine, group), gradient_of(*theirs, group)), 1e-4)
          << group;
    }
    EXPECT_LT(relative_difference(values_of(*mine), values_of(*theirs)), 1e-4);
  }
}

// Needs wide tolerances, because Adam divides by the root of its second moment. Rounding of a
// gradient near zero moves a weight as much as a large gradient does. Three steps leave fewer
// digits than one step.
TEST_P(TwinAgainstLibtorch, FollowsLibtorchThroughBothStagesAndPartialBatches) {
  TwinTask task = task_of(GetParam());
  // Other coders have at least two layers.
  for (const int depth : {task.variant.coder == CoderKind::dense ? 1 : 2, 3}) {
    task.options.depth = depth;
    const auto mine = one_core_engine(Device::cpu).train(task, Stream("initial"));
    const auto theirs = libtorch::twin_engine(Device::cpu).train(task, Stream("initial"));
    const auto step = [&](TrainingStage stage, const std::vector<std::size_t>& batch) {
      const BatchLosses own = mine->step(stage, batch, rates);
      const BatchLosses other = theirs->step(stage, batch, rates);
      EXPECT_NEAR(own.reconstruction, other.reconstruction, 1e-3 * other.reconstruction);
      EXPECT_NEAR(own.total, other.total, 1e-3 * std::abs(other.total));
    };
    step(TrainingStage::one, {7, 2, 5, 0, 8});
    step(TrainingStage::one, {1, 4});
    step(TrainingStage::two, {3, 6, 1});
    EXPECT_LT(relative_difference(values_of(*mine), values_of(*theirs)), 1e-3) << "depth " << depth;
  }
}

TEST_P(TwinAgainstLibtorch, MatchesTheStatesOfLibtorch) {
  const TwinTask task = task_of(GetParam());
  const std::vector<TwinPoint> mine =
      one_core_engine(Device::cpu).train(task, Stream("initial"))->states();
  const std::vector<TwinPoint> theirs =
      libtorch::twin_engine(Device::cpu).train(task, Stream("initial"))->states();
  ASSERT_EQ(mine.size(), task.labels.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_NEAR(mine[i].k, theirs[i].k, 1e-6);
    EXPECT_NEAR(mine[i].c, theirs[i].c, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Twin, TwinAgainstLibtorch,
    testing::Values(TaskOf{"Full", full_model, LossWeights::adaptive, 1e9},
                    TaskOf{"FullClipped", full_model, LossWeights::adaptive, 0.01},
                    TaskOf{"FullFixed", full_model, LossWeights::fixed, 1e9},
                    TaskOf{"FullStationary", full_model, LossWeights::stationary, 1e9},
                    TaskOf{"FullWithoutLog", full_model, LossWeights::adaptive_without_log, 1e9},
                    TaskOf{"OtherReadings", full_model, LossWeights::adaptive, 1e9, true},
                    TaskOf{"WithoutPhysics", without_physics, LossWeights::adaptive, 0.01},
                    TaskOf{"Convolutional", convolutional_model, LossWeights::adaptive, 1e9},
                    TaskOf{"ConvolutionalClipped", convolutional_model, LossWeights::adaptive,
                           0.01},
                    TaskOf{"Recurrent", recurrent_model, LossWeights::adaptive, 1e9},
                    TaskOf{"RecurrentClipped", recurrent_model, LossWeights::adaptive, 0.01},
                    TaskOf{"WithoutEncoder", without_encoder, LossWeights::adaptive, 1e9},
                    TaskOf{"Temporal", temporal_model, LossWeights::adaptive, 1e9},
                    TaskOf{"TemporalClipped", temporal_model, LossWeights::adaptive, 0.01},
                    TaskOf{"Transformer", transformer_model, LossWeights::adaptive, 1e9},
                    TaskOf{"TransformerClipped", transformer_model, LossWeights::adaptive, 0.01}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace piae::twin
