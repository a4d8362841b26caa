#include "diagnosis/symptom_net.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include "diagnosis/symptom_network.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

double learning_rate_in(std::int64_t epoch) {
  const double done = static_cast<double>(epoch - 1) / static_cast<double>(SymptomTraining::epochs);
  return SymptomTraining::learning_rate * (1 + std::cos(std::numbers::pi * done)) / 2;
}

/// The chosen rows, each symptom moved a little at random.
SymptomRows noisy(const SymptomRows& all, std::span<const std::size_t> chosen, Stream& noise) {
  SymptomRows rows(chosen.size(), SymptomRows::ColsAtCompileTime);
  for (Index i = 0; i < rows.rows(); ++i) {
    rows.row(i) = all.row(static_cast<Index>(chosen[static_cast<std::size_t>(i)]));
    for (double& symptom : rows.row(i)) symptom += noise.normal(0, SymptomTraining::noise);
  }
  return rows;
}

void run_symptom_epoch(SymptomNetwork& network, const SymptomInputs& inputs, std::int64_t epoch,
                       const Stream& stream, WdcnnResult& result) {
  Stream own = stream.child("epoch" + std::to_string(epoch));
  Stream noise = own.child("noise");
  Stream dropped = own.child("dropout");
  const std::vector<std::size_t> order = own.permutation(inputs.labels.size());
  constexpr auto batch = static_cast<std::size_t>(SymptomTraining::batch);
  BatchOutcome sums;
  for (std::size_t begin = 0; begin < order.size(); begin += batch) {
    const auto chosen = std::span(order).subspan(begin, std::min(batch, order.size() - begin));
    std::vector<Label> labels(chosen.size());
    std::ranges::transform(chosen, labels.begin(), [&](std::size_t i) { return inputs.labels[i]; });
    const BatchOutcome outcome = network.step(noisy(inputs.training, chosen, noise), labels,
                                              learning_rate_in(epoch), dropped);
    sums.loss += outcome.loss;
    sums.correct += outcome.correct;
  }
  const auto n = static_cast<double>(order.size());
  result.loss.push_back(sums.loss / n);
  result.train_accuracy.push_back(static_cast<double>(sums.correct) / n);
}

void test_network(SymptomNetwork& network, const SymptomRows& test, std::int64_t classes,
                  WdcnnResult& result) {
  for (Index i = 0; i < test.rows(); ++i) {
    const SymptomNetwork::Outputs outputs = network.outputs(test.row(i));
    std::vector<float> logits(outputs.logits.data(), outputs.logits.data() + classes);
    std::vector<float> scores(logits.size());
    softmax(classes, logits.data(), scores.data());
    const auto named = std::ranges::max_element(scores) - scores.begin();
    result.predictions.push_back(static_cast<Label>(named));
    WdcnnOutputs& all = result.outputs;
    all.hidden.insert(all.hidden.end(), outputs.hidden.data(),
                      outputs.hidden.data() + SymptomNetwork::hidden);
    all.logits.insert(all.logits.end(), logits.begin(), logits.end());
    all.scores.insert(all.scores.end(), scores.begin(), scores.end());
  }
}

}  // namespace

WdcnnResult train_and_test_symptoms(const signal::WindowSet& normal,
                                    const signal::WindowSet& training,
                                    const signal::WindowSet& test, const Stream& stream,
                                    const EpochDone& epoch_done) {
  const SymptomInputs inputs = symptom_inputs(normal, training, test);
  const auto classes = static_cast<std::int64_t>(test.info.classes.size());
  SymptomNetwork network(classes, SymptomTraining::batch, stream.child("initial"));
  WdcnnResult result;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= SymptomTraining::epochs; ++epoch) {
    run_symptom_epoch(network, inputs, epoch, stream, result);
    if (epoch_done) epoch_done(epoch, result.loss.back());
  }
  result.training_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  test_network(network, inputs.test, classes, result);
  return result;
}

}  // namespace piae::diagnosis
