#include "diagnosis/wdcnn_evaluation.hpp"

#include <algorithm>
#include <vector>

#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/wdcnn_layers.hpp"

namespace piae::diagnosis {

namespace {

/// Enough to fill the registers of the matrix products, and few enough for the caches.
constexpr std::int64_t evaluation_batch = 32;

class TrainedNetwork final : public Wdcnn {
 public:
  explicit TrainedNetwork(const WdcnnWeights& weights)
      : network_(weights.length, weights.classes, evaluation_batch, Stream("overwritten")) {
    network_.set(weights);
  }

  Outputs outputs(const LabelledWindows& windows) override {
    return outputs_of(network_, evaluation_batch, windows);
  }
  [[nodiscard]] WdcnnWeights weights() const override { return network_.weights(); }

 private:
  WdcnnNetwork<float> network_;
};

}  // namespace

Outputs outputs_of(WdcnnNetwork<float>& network, std::int64_t batch,
                   const LabelledWindows& windows) {
  const std::size_t classes = windows.classes;
  Outputs all;
  all.scores.resize(windows.size() * classes);
  std::vector<const float*> pointers;
  for (std::size_t begin = 0; begin < windows.size(); begin += pointers.size()) {
    pointers.clear();
    const auto end = std::min(windows.size(), begin + static_cast<std::size_t>(batch));
    for (std::size_t i = begin; i < end; ++i) {
      pointers.push_back(windows.samples.data() + i * windows.length);
    }
    const float* logits = network.forward(pointers, WdcnnNetwork<float>::Mode::evaluation);
    const float* hidden = network.hidden();
    for (std::size_t i = begin; i < end; ++i, logits += network.logits_row()) {
      softmax(static_cast<std::int64_t>(classes), logits, all.scores.data() + i * classes);
      all.logits.insert(all.logits.end(), logits, logits + classes);
      all.hidden.insert(all.hidden.end(), hidden, hidden + WdcnnLayers::hidden);
      hidden += network.hidden_row();
    }
  }
  return all;
}

std::unique_ptr<Wdcnn> wdcnn_of(const WdcnnWeights& weights) {
  return std::make_unique<TrainedNetwork>(weights);
}

}  // namespace piae::diagnosis
