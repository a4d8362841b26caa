// Whole steps of our back end against LibTorch's, from the same parameters.

#include "twin/dense_backend.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "known_windows.hpp"
#include "nets/steps.hpp"
#include "signal/amplitude.hpp"
#include "libtorch/twin/backend.hpp"
#include "signal/scaling.hpp"

namespace piae::twin {
namespace {

struct Case {
  const char* name;
  TwinVariant variant;
  const char* loss_weights;
  double max_gradient_norm;  ///< of which 0.01 clips
};

TwinTask task_of(const Case& c) {
  const signal::WindowSet known = known_windows();
  const std::vector<double> scale = signal::rms_by_class(known);
  TwinTask task;
  task.variant = c.variant;
  task.options.width = 24;
  task.options.loss_weights = c.loss_weights;
  task.options.max_gradient_norm = c.max_gradient_norm;
  task.shape = {static_cast<std::int64_t>(known.length),
                static_cast<std::int64_t>(known.info.classes.size())};
  task.physics = make_physics(known.info, scale, task.options);
  task.windows = scaled_windows(known, scale);
  task.labels = known.labels;
  if (c.variant.encoder) return task;
  task.states.emplace();
  for (std::size_t i = 0; i < task.labels.size(); ++i) {
    const auto x = static_cast<double>(i);
    task.states->points.push_back({1 + 0.1 * x, 5 - 0.2 * x});
    task.states->decoder_inputs.push_back({0.3 * x - 1, 1 - 0.1 * x});
  }
  return task;
}

std::vector<float> values_of(const TwinBackend& backend) {
  std::vector<float> values(nets::total_size(backend.specs()));
  backend.copy_values(values);
  return values;
}

/// The gradient of the one step that was taken: ten times Adam's first moment.
std::vector<float> gradient_of(const TwinBackend& backend, const std::string& group) {
  return nets::first_moments([&](artefact::Writer& writer) { backend.write_adam(writer, "/adam"); },
                             "/adam/" + group);
}

class NativeTwin : public testing::TestWithParam<Case> {};

// In single precision: LibTorch takes the distances of eq. 21's MMD from products, which leaves it
// five digits.
TEST_P(NativeTwin, StepsAsLibtorchDoes) {
  const TwinTask task = task_of(GetParam());
  const std::vector<std::size_t> batch{7, 2, 5, 0, 8};
  for (const TrainingStage stage : {TrainingStage::one, TrainingStage::two}) {
    const auto mine = native_engine("cpu").train(task, Stream("initial"));
    const auto theirs = libtorch_engine("cpu").train(task, Stream("initial"));
    ASSERT_EQ(values_of(*mine), values_of(*theirs));
    const BatchLosses own = mine->step(stage, batch, 1e-3);
    const BatchLosses other = theirs->step(stage, batch, 1e-3);
    EXPECT_NEAR(own.reconstruction, other.reconstruction, 1e-5 * other.reconstruction);
    EXPECT_NEAR(own.differential, other.differential, 1e-5 * other.differential);
    EXPECT_NEAR(own.twin, other.twin, 1e-4 * other.twin);
    EXPECT_NEAR(own.total, other.total, 1e-5 * std::abs(other.total));
    for (const std::string group : {"networks", "loss_weights"}) {
      EXPECT_LT(nets::difference(gradient_of(*mine, group), gradient_of(*theirs, group)), 1e-4)
          << group;
    }
    EXPECT_LT(nets::difference(values_of(*mine), values_of(*theirs)), 1e-4);
  }
}

// Adam divides by the root of its second moment, so that the last digits of a gradient near zero
// move a weight as far as any: three steps leave fewer digits than one.
TEST_P(NativeTwin, FollowsLibtorchThroughBothStagesAndBatchesThatAreNotFull) {
  TwinTask task = task_of(GetParam());
  for (const int depth : {1, 3}) {
    task.options.depth = depth;
    const auto mine = native_engine("cpu").train(task, Stream("initial"));
    const auto theirs = libtorch_engine("cpu").train(task, Stream("initial"));
    const auto step = [&](TrainingStage stage, const std::vector<std::size_t>& batch) {
      const BatchLosses own = mine->step(stage, batch, 1e-3);
      const BatchLosses other = theirs->step(stage, batch, 1e-3);
      EXPECT_NEAR(own.reconstruction, other.reconstruction, 1e-3 * other.reconstruction);
      EXPECT_NEAR(own.total, other.total, 1e-3 * std::abs(other.total));
    };
    step(TrainingStage::one, {7, 2, 5, 0, 8});
    step(TrainingStage::one, {1, 4});
    step(TrainingStage::two, {3, 6, 1});
    EXPECT_LT(nets::difference(values_of(*mine), values_of(*theirs)), 1e-3) << "depth " << depth;
  }
}

TEST(NativeTwinEngine, RefusesAnotherDevice) {
  try {
    native_engine("cuda");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_NE(std::string(error.what()).find("use libtorch"), std::string::npos) << error.what();
  }
}

TEST_P(NativeTwin, GivesTheStatesThatLibtorchGives) {
  const TwinTask task = task_of(GetParam());
  const std::vector<TwinPoint> mine = native_engine("cpu").train(task, Stream("initial"))->states();
  const std::vector<TwinPoint> theirs =
      libtorch_engine("cpu").train(task, Stream("initial"))->states();
  ASSERT_EQ(mine.size(), task.labels.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_NEAR(mine[i].k, theirs[i].k, 1e-6);
    EXPECT_NEAR(mine[i].c, theirs[i].c, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Twin, NativeTwin,
                         testing::Values(Case{"Full", full_model, "adaptive", 1e9},
                                         Case{"FullClipped", full_model, "adaptive", 0.01},
                                         Case{"FullFixed", full_model, "fixed", 1e9},
                                         Case{"FullWithoutLog", full_model, "adaptive-without-log",
                                              1e9},
                                         Case{"WithoutPhysics", without_physics, "adaptive", 0.01},
                                         Case{"WithoutEncoder", without_encoder, "adaptive", 1e9}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace piae::twin
