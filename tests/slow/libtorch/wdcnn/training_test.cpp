#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_cases.hpp"
#include "diagnosis/wdcnn_evaluation.hpp"
#include "libtorch/wdcnn/backend.hpp"

namespace piae::diagnosis {
namespace {

INSTANTIATE_TEST_SUITE_P(Libtorch, WdcnnTraining,
                         testing::Values(TrainedBy{"Libtorch", libtorch::wdcnn_on(Device::cpu)}),
                         name_of);

TEST(WdcnnBackends, AgreeUntilRoundingGrows) {
  const LabelledWindows train = tones(11, "train");  // 33 windows: the last batch has 9
  const LabelledWindows test = tones(20, "test");
  const auto run = [&](const MakeWdcnnBackend& backend) {
    return train_and_test(train, test, short_training(4), Stream("course"), backend);
  };
  const WdcnnResult one_core = run(make_one_core_backend);
  const WdcnnResult theirs = run(libtorch::wdcnn_on(Device::cpu));
  for (std::size_t epoch = 0; epoch < 4; ++epoch) {
    EXPECT_NEAR(one_core.training.loss[epoch], theirs.training.loss[epoch],
                1e-3 * theirs.training.loss[epoch]);
    EXPECT_NEAR(one_core.training.train_accuracy[epoch], theirs.training.train_accuracy[epoch],
                1.5 / 33);
  }
  for (std::size_t i = 0; i < one_core.outputs.scores.size(); ++i) {
    EXPECT_NEAR(one_core.outputs.scores[i], theirs.outputs.scores[i], 0.02);
  }
}

/// Uses steps too small for learning, so the networks stay equal and rounding does not grow.
TEST(WdcnnBackends, PredictTheSameForEachWindow) {
  const LabelledWindows test = tones(40, "test");
  WdcnnOptions options = short_training(1);
  options.learning_rate = 1e-12;
  const auto run = [&](const MakeWdcnnBackend& backend) {
    return train_and_test(tones(11, "train"), test, options, Stream("same"), backend).outputs;
  };
  const auto expect_near = [](const std::vector<float>& ours, const std::vector<float>& theirs) {
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      ASSERT_NEAR(ours[i], theirs[i], 1e-4 * (1 + std::abs(theirs[i]))) << i;
    }
  };
  const Outputs one_core = run(make_one_core_backend);
  const Outputs theirs = run(libtorch::wdcnn_on(Device::cpu));
  expect_near(one_core.hidden, theirs.hidden);
  expect_near(one_core.logits, theirs.logits);
}

// Checks that our network for one core gives the same outputs with weights learned by either back
// end.
TEST(WdcnnBackends, ExchangeWeights) {
  const LabelledWindows test = tones(20, "test");
  for (const MakeWdcnnBackend& backend :
       {MakeWdcnnBackend(make_one_core_backend), libtorch::wdcnn_on(Device::cpu)}) {
    const TrainedWdcnn trained =
        train_wdcnn(tones(11, "train"), short_training(3), Stream("weights"), backend);
    const std::vector<float> logits = trained.network->outputs(test).logits;
    const std::vector<float> ours = wdcnn_of(trained.network->weights())->outputs(test).logits;
    ASSERT_EQ(ours.size(), logits.size());
    for (std::size_t i = 0; i < logits.size(); ++i) {
      ASSERT_NEAR(ours[i], logits[i], 1e-4 * (1 + std::abs(logits[i]))) << i;
    }
  }
}

}  // namespace
}  // namespace piae::diagnosis
