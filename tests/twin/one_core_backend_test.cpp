// Compares whole steps of the twin on one core with finite differences of the reported losses.

#include "twin/one_core_backend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/gradients.hpp"
#include "twin/example_task.hpp"

namespace piae::twin {
namespace {

const std::vector<std::size_t> batch{7, 2, 5, 0, 8};
constexpr LearningRates rates{.networks = 1e-3, .loss_weights = 1e-3};

/// Returns the gradient of the only step from these parameters, of "networks" or "loss_weights".
std::vector<float> gradient_of(const TwinBackend& backend, const std::string& group) {
  std::vector<float> gradient = first_moments(
      [&](artefact::Writer& writer) { backend.write_adam(writer, "/adam"); }, "/adam/" + group);
  for (float& g : gradient) g *= 10;  // 1 - beta1 = 0.1
  return gradient;
}

/// Returns the losses of the batch at other parameters.
BatchLosses losses_at(const TwinTask& task, const std::vector<float>& values) {
  const auto probe = one_core_engine(Device::cpu).train(task, Stream("initial"));
  probe->set_values(values);
  return probe->step(TrainingStage::one, batch, rates);
}

/// Position, in the flat list, of the parameters of a network or of several consecutive networks.
struct Range {
  std::size_t begin;
  std::size_t end;
};
Range range_of(const TwinBackend& backend, const std::string& prefix) {
  Range range{0, 0};
  std::size_t at = 0;
  for (const nets::ParameterSpec& spec : backend.specs()) {
    const std::size_t next = at + static_cast<std::size_t>(spec.size());
    if (spec.name.starts_with(prefix)) {
      if (range.end == 0) range.begin = at;
      range.end = next;
    }
    at = next;
  }
  return range;
}

std::vector<float> part_of(const std::vector<float>& all, const Range& range) {
  return {all.begin() + static_cast<std::ptrdiff_t>(range.begin),
          all.begin() + static_cast<std::ptrdiff_t>(range.end)};
}

/// Expects the parameters below `prefix` to follow the gradient of `loss` in a step of this stage.
void expect_followed(const TwinTask& task, TrainingStage stage, const std::string& prefix,
                     const std::function<double(const BatchLosses&)>& loss) {
  SCOPED_TRACE(prefix);
  const auto backend = one_core_engine(Device::cpu).train(task, Stream("initial"));
  const std::vector<float> start = values_of(*backend);
  const Range range = range_of(*backend, prefix);
  backend->step(stage, batch, rates);
  expect_gradient_of(part_of(gradient_of(*backend, "networks"), range), part_of(start, range),
                     [&](const std::vector<float>& part) {
                       std::vector<float> values = start;
                       std::ranges::copy(part,
                                         values.begin() + static_cast<std::ptrdiff_t>(range.begin));
                       return loss(losses_at(task, values));
                     });
}

constexpr double unclipped = 1e9;

TEST(OneCoreTwin, EachNetworkFollowsItsOwnLossInStageOne) {
  for (const TaskOf& c : {TaskOf{"Full", full_model, LossWeights::adaptive, unclipped},
                          TaskOf{"Recurrent", recurrent_model, LossWeights::adaptive, unclipped}}) {
    SCOPED_TRACE(c.name);
    const TwinTask task = task_of(c);
    expect_followed(task, TrainingStage::one, "net/encoder/",
                    [](const BatchLosses& losses) { return losses.twin; });
    expect_followed(task, TrainingStage::one, "net/decoder/",
                    [](const BatchLosses& losses) { return losses.reconstruction; });
    expect_followed(task, TrainingStage::one, "net/physics/",
                    [](const BatchLosses& losses) { return losses.differential; });
  }
}

TEST(OneCoreTwin, EveryNetworkFollowsTheTotalInStageTwo) {
  for (const LossWeights loss_weights : {LossWeights::adaptive, LossWeights::adaptive_without_log,
                                         LossWeights::stationary, LossWeights::fixed}) {
    SCOPED_TRACE(static_cast<int>(loss_weights));
    expect_followed(task_of({"Full", full_model, loss_weights, unclipped}), TrainingStage::two,
                    "net/", [](const BatchLosses& losses) { return losses.total; });
  }
}

TEST(OneCoreTwin, CoderWithoutPhysicsFollowsTheReconstruction) {
  const TwinTask task =
      task_of({"WithoutPhysics", without_physics, LossWeights::adaptive, unclipped});
  for (const TrainingStage stage : {TrainingStage::one, TrainingStage::two}) {
    expect_followed(task, stage, "net/",
                    [](const BatchLosses& losses) { return losses.reconstruction; });
  }
}

TEST(OneCoreTwin, DecoderWithoutEncoderFollowsTheReconstruction) {
  const TwinTask task = task_of({"WithoutEncoder", without_encoder, LossWeights::fixed, unclipped});
  expect_followed(task, TrainingStage::one, "net/",
                  [](const BatchLosses& losses) { return losses.reconstruction; });
}

// Initially all weights are 1. The derivative by ln alpha is alpha L_DDL - 1/2, and so on; without
// the logarithms it is the loss itself.
TEST(OneCoreTwin, LossWeightsFollowTheClosedFormOfEquation23) {
  for (const auto& [loss_weights, held] :
       {std::pair{LossWeights::adaptive, 0.5}, std::pair{LossWeights::adaptive_without_log, 0.0}}) {
    const TwinTask task = task_of({"Full", full_model, loss_weights, unclipped});
    const auto backend = one_core_engine(Device::cpu).train(task, Stream("initial"));
    const BatchLosses losses = backend->step(TrainingStage::two, batch, rates);
    const std::vector<float> gradient = gradient_of(*backend, "loss_weights");
    ASSERT_EQ(gradient.size(), 3U);
    EXPECT_NEAR(gradient[0], losses.differential - held, 1e-5 * (1 + losses.differential));
    EXPECT_NEAR(gradient[1], losses.twin - held, 1e-5 * (1 + losses.twin));
    EXPECT_NEAR(gradient[2], losses.reconstruction - held, 1e-5 * (1 + losses.reconstruction));
    EXPECT_NEAR(losses.total, losses.differential + losses.twin + losses.reconstruction,
                1e-6 * losses.total);
  }
}

TEST(OneCoreTwin, ClipsLongGradients) {
  constexpr double longest = 0.01;
  const TwinTask task = task_of({"Clipped", full_model, LossWeights::adaptive, longest});
  const TwinTask free = task_of({"Free", full_model, LossWeights::adaptive, unclipped});
  const auto norm = [](const std::vector<float>& gradient) {
    double squares = 0;
    for (const float g : gradient) squares += static_cast<double>(g) * g;
    return std::sqrt(squares);
  };
  const auto clipped = one_core_engine(Device::cpu).train(task, Stream("initial"));
  const auto unbounded = one_core_engine(Device::cpu).train(free, Stream("initial"));
  clipped->step(TrainingStage::one, batch, rates);
  unbounded->step(TrainingStage::one, batch, rates);
  for (const std::string prefix : {"net/encoder/", "net/decoder/", "net/physics/"}) {
    const Range range = range_of(*clipped, prefix);
    EXPECT_GT(norm(part_of(gradient_of(*unbounded, "networks"), range)), longest) << prefix;
    EXPECT_NEAR(norm(part_of(gradient_of(*clipped, "networks"), range)), longest, 1e-6) << prefix;
  }
}

TEST(OneCoreTwin, GivesAStateForEveryKnownWindow) {
  const TwinTask task = task_of({"Full", full_model, LossWeights::adaptive, unclipped});
  const std::vector<TwinPoint> states =
      one_core_engine(Device::cpu).train(task, Stream("initial"))->states();
  ASSERT_EQ(states.size(), task.labels.size());
  for (const TwinPoint& state : states) {
    EXPECT_GT(state.k, 0);  // by softplus
    EXPECT_GT(state.c, 0);
  }
  EXPECT_NE(states[0].k, states[1].k);
}

TEST(OneCoreTwin, WithoutAnEncoderKeepsItsStates) {
  const TwinTask task = task_of({"WithoutEncoder", without_encoder, LossWeights::fixed, unclipped});
  const std::vector<TwinPoint> states =
      one_core_engine(Device::cpu).train(task, Stream("initial"))->states();
  ASSERT_EQ(states.size(), task.labels.size());
  EXPECT_EQ(states[3].k, task.states->points[3].k);
  EXPECT_EQ(states[3].c, task.states->points[3].c);
}

}  // namespace
}  // namespace piae::twin
