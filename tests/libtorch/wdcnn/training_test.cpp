#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/training_cases.hpp"
#include "libtorch/wdcnn/backend.hpp"

namespace piae::diagnosis {
namespace {

INSTANTIATE_TEST_SUITE_P(Libtorch, WdcnnTraining,
                         testing::Values(TrainedBy{"Libtorch", libtorch::wdcnn_on(Device::cpu)}),
                         name_of);

TEST(WdcnnBackends, FollowOneCourseUntilRoundingHasGrown) {
  const LabelledWindows train = tones(11, "train");  // 33 windows: the last batch is of 9
  const LabelledWindows test = tones(20, "test");
  const auto run = [&](const MakeWdcnnBackend& backend) {
    return train_and_test(train, test, short_training(4), Stream("course"), backend);
  };
  const WdcnnResult one_core = run(make_one_core_backend);
  const WdcnnResult theirs = run(libtorch::wdcnn_on(Device::cpu));
  for (std::size_t epoch = 0; epoch < 4; ++epoch) {
    EXPECT_NEAR(one_core.loss[epoch], theirs.loss[epoch], 1e-3 * theirs.loss[epoch]);
    EXPECT_NEAR(one_core.train_accuracy[epoch], theirs.train_accuracy[epoch], 1.5 / 33);
  }
  for (std::size_t i = 0; i < one_core.scores.size(); ++i) {
    EXPECT_NEAR(one_core.scores[i], theirs.scores[i], 0.02);
  }
}

}  // namespace
}  // namespace piae::diagnosis
