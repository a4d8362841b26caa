#include "diagnosis/wdcnn_weights.hpp"

#include <gtest/gtest.h>

#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/stored.hpp"
#include "diagnosis/wdcnn.hpp"
#include "diagnosis/wdcnn_evaluation.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

/// Returns a network with a short training.
TrainedWdcnn little_trained() {
  return train_wdcnn(tones(6, "weights"), {.epochs = 2, .batch = 8, .learning_rate = 1e-3},
                     Stream("weights"), make_one_core_backend);
}

const WdcnnWeights& learned_weights() {
  static const WdcnnWeights weights = little_trained().network->weights();
  return weights;
}

class StoredWeights : public testing::Test {
 protected:
  [[nodiscard]] artefact::Reader stored_weights(const WdcnnWeights& weights) const {
    artefact::Writer writer("weights");
    write(writer, "/net", weights);
    return stored(writer, folder_);
  }
  const Folder folder_;
};

TEST_F(StoredWeights, AreReadAsWrittenUnderTheirLayerNames) {
  const WdcnnWeights& weights = learned_weights();
  const artefact::Reader reader = stored_weights(weights);
  const WdcnnWeights read = read_wdcnn_weights(reader, "/net", 1024, 3);
  EXPECT_EQ(read.length, 1024);
  EXPECT_EQ(read.classes, 3);
  EXPECT_EQ(read.parameters, weights.parameters);
  EXPECT_EQ(read.running_means, weights.running_means);
  EXPECT_EQ(read.running_variances, weights.running_variances);
  // The running statistics differ from their initial values; otherwise this test would see nothing.
  EXPECT_NE(read.running_means[5], std::vector<float>(100, 0));
  EXPECT_NE(read.running_variances[0], std::vector<float>(16, 1));
  for (const std::string name :
       {"conv1/weight", "conv5/running_mean", "dense/running_variance", "classes/bias"}) {
    EXPECT_TRUE(reader.has("/net/" + name)) << name;
  }
}

TEST_F(StoredWeights, PredictLikeTheTrainedNetwork) {
  const TrainedWdcnn learned = little_trained();
  const LabelledWindows tested = tones(25, "asked");  // 75: more than one batch
  const Outputs before = learned.network->outputs(tested);
  const Outputs after = wdcnn_of(learned.network->weights())->outputs(tested);
  EXPECT_EQ(after.scores, before.scores);
  EXPECT_EQ(after.logits, before.logits);
  EXPECT_EQ(after.hidden, before.hidden);
}

TEST_F(StoredWeights, NeedTheRightShape) {
  const artefact::Reader reader = stored_weights(learned_weights());
  EXPECT_ERROR(read_wdcnn_weights(reader, "/net", 2048, 3), Exit::bad_input, "/net/dense/weight");
  EXPECT_ERROR(read_wdcnn_weights(reader, "/net", 1024, 4), Exit::bad_input, "/net/classes/");
  EXPECT_ERROR(read_wdcnn_weights(reader, "/other", 1024, 3), Exit::bad_input, "/other/conv1");
}

TEST_F(StoredWeights, NeedVariancesFromZeroUp) {
  WdcnnWeights weights = learned_weights();
  weights.running_variances[5][99] = -1e-6F;
  EXPECT_ERROR(read_wdcnn_weights(stored_weights(weights), "/net", 1024, 3), Exit::bad_input,
               "/net/dense/running_variance has a variance below 0");
}

}  // namespace
}  // namespace piae::diagnosis
