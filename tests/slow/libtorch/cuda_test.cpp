// Compares LibTorch on a CUDA device with our own kernels from the same parameters: equal except
// for rounding. Skips without such a device.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/train_and_test.hpp"
#include "diffusion/example_batch.hpp"
#include "diffusion/model.hpp"
#include "latent/example_task.hpp"
#include "latent/vae.hpp"
#include "latent/wgan_gp.hpp"
#include "libtorch/diffusion/backend.hpp"
#include "libtorch/latent/backends.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/backend.hpp"
#include "libtorch/wdcnn/backend.hpp"
#include "support/gradients.hpp"
#include "twin/example_task.hpp"
#include "twin/one_core_backend.hpp"

namespace piae {
namespace {

class OnCuda : public testing::Test {
 protected:
  void SetUp() override {
    if (!torch::cuda::is_available()) GTEST_SKIP() << "LibTorch finds no CUDA device";
  }
};

/// Tolerance after a step of Adam, which divides by the root of its second moment. Rounding of a
/// gradient near zero therefore moves a weight as much as a large gradient does.
constexpr double after_adam = 1e-3;

void expect_near(const std::vector<float>& ours, const std::vector<float>& theirs,
                 double tolerance) {
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_NEAR(ours[i], theirs[i], tolerance * (1 + std::abs(ours[i]))) << i;
  }
}

TEST_F(OnCuda, EveryVariantOfTheTwinStepsAndEncodes) {
  using namespace twin;
  for (const TwinVariant& variant :
       {full_model, without_physics, convolutional_model, recurrent_model, without_encoder,
        temporal_model, transformer_model}) {
    const TwinTask task = task_of({"", variant, LossWeights::adaptive, 1e9});
    for (const TrainingStage stage : {TrainingStage::one, TrainingStage::two}) {
      const auto ours = one_core_engine(Device::cpu).train(task, Stream("initial"));
      const auto theirs = libtorch::twin_engine(Device::cuda).train(task, Stream("initial"));
      ASSERT_EQ(values_of(*ours), values_of(*theirs));
      const std::vector<std::size_t> batch{7, 2, 5, 0, 8};
      const LearningRates rates{.networks = 1e-3, .loss_weights = 2e-2};
      const BatchLosses own = ours->step(stage, batch, rates);
      const BatchLosses other = theirs->step(stage, batch, rates);
      EXPECT_NEAR(own.reconstruction, other.reconstruction, 1e-5 * own.reconstruction);
      EXPECT_NEAR(own.differential, other.differential, 1e-5 * own.differential);
      EXPECT_NEAR(own.twin, other.twin, 1e-4 * own.twin);
      EXPECT_LT(relative_difference(values_of(*theirs), values_of(*ours)), after_adam);
    }
    const auto states = [&](const MakeEngine engine, Device device) {
      std::vector<float> numbers;
      for (const TwinPoint& point : engine(device).train(task, Stream("initial"))->states()) {
        numbers.push_back(static_cast<float>(point.k));
        numbers.push_back(static_cast<float>(point.c));
      }
      return numbers;
    };
    expect_near(states(one_core_engine, Device::cpu), states(libtorch::twin_engine, Device::cuda),
                1e-5);
  }
}

/// Takes two steps, the second with a smaller batch.
void expect_equal_steps(latent::LatentBackend& ours, latent::LatentBackend& theirs) {
  ASSERT_EQ(ours.values(), theirs.values());
  Stream our_noise("noise");
  Stream their_noise("noise");
  const std::vector<std::vector<std::size_t>> batches{{5, 1, 2, 0}, {3, 4}};
  for (std::size_t i = 0; i < batches.size(); ++i) {
    const std::vector<double> own = ours.step(i, batches[i], our_noise);
    const std::vector<double> other = theirs.step(i, batches[i], their_noise);
    ASSERT_EQ(own.size(), other.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      EXPECT_NEAR(own[k], other[k], 1e-5 * (1 + std::abs(own[k])));
    }
    EXPECT_LT(relative_difference(theirs.values(), ours.values()), after_adam);
  }
}

TEST_F(OnCuda, TheVaeSteps) {
  const latent::LatentTask task = latent::example_task(50, 3, 7, 24);
  expect_equal_steps(*latent::vae(task, Stream("initial"), Device::cpu),
                     *libtorch::vae(task, Stream("initial"), Device::cuda));
}

TEST_F(OnCuda, TheWganGpSteps) {
  const latent::LatentTask task = latent::example_task(50, 3, 7, 24);
  const latent::WganGpOptions options{.critic_steps = 2};
  expect_equal_steps(*latent::wgan_gp(task, options, Stream("initial"), Device::cpu),
                     *libtorch::wgan_gp(task, options, Stream("initial"), Device::cuda));
}

TEST_F(OnCuda, BothNetworksOfADiffusionStep) {
  using namespace diffusion;
  const Networks networks =
      networks_of(64, 3, {{.channels = 32, .blocks = 3}, {.channels = 16, .blocks = 2}});
  const auto ours = one_core_diffusion(networks, 4, Stream("initial"), Device::cpu);
  const auto theirs = libtorch::diffusion_backend(networks, 4, Stream("initial"), Device::cuda);
  ASSERT_EQ(ours->values(), theirs->values());
  const NoisyBatch batch = example_batch(64, 4);
  const std::vector<float> wanted = example_velocities(batch);
  for (std::size_t trained = 0; trained < networks.size(); ++trained) {
    EXPECT_LT(relative_difference(theirs->velocities(batch, trained + 1),
                                  ours->velocities(batch, trained + 1)),
              1e-4);
    const double own = ours->step(trained, batch, wanted, 1e-3);
    EXPECT_NEAR(theirs->step(trained, batch, wanted, 1e-3), own, 1e-5 * own);
    EXPECT_LT(relative_difference(theirs->values(), ours->values()), after_adam);
  }
}

/// Uses steps too small for learning, so the networks stay equal and rounding does not grow.
TEST_F(OnCuda, WdcnnPredictsTheSameForEachWindow) {
  using namespace diagnosis;
  WdcnnOptions options;
  options.epochs = 1;
  options.batch = 8;
  options.learning_rate = 1e-12;
  const LabelledWindows test = tones(40, "test");
  const auto outputs = [&](const MakeWdcnnBackend& backend) {
    return train_and_test(tones(11, "train"), test, options, Stream("same"), backend).outputs;
  };
  const Outputs ours = outputs(make_one_core_backend);
  const Outputs theirs = outputs(libtorch::wdcnn_on(Device::cuda));
  expect_near(ours.hidden, theirs.hidden, 1e-4);
  expect_near(ours.logits, theirs.logits, 1e-4);
}

}  // namespace
}  // namespace piae
