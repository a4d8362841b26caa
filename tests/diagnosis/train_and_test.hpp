#pragma once

#include <utility>
#include <vector>

#include "diagnosis/wdcnn.hpp"

namespace piae::diagnosis {

/// A training of WDCNN, and the network's output for other windows.
struct WdcnnResult {
  Training training;
  Outputs outputs;
  std::vector<Label> predictions;
};

inline WdcnnResult train_and_test(LabelledWindows train, const LabelledWindows& test,
                                  const WdcnnOptions& options, const Stream& stream,
                                  const MakeWdcnnBackend& make_backend,
                                  const EpochDone& epoch_done = {}) {
  const std::size_t length = train.length;
  TrainedWdcnn trained = train_wdcnn(std::move(train), options, stream, make_backend, epoch_done);
  Outputs outputs = predict_by_wdcnn(*trained.network, length, test);
  std::vector<Label> predictions = most_likely(outputs.scores, test.classes);
  return {std::move(trained.training), std::move(outputs), std::move(predictions)};
}

}  // namespace piae::diagnosis
