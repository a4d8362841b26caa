#include "diagnosis/symptom_training.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace piae::diagnosis {

namespace {

using Eigen::Index;

double learning_rate_in(std::int64_t epoch) {
  const double done = static_cast<double>(epoch - 1) / static_cast<double>(SymptomTraining::epochs);
  return SymptomTraining::learning_rate * (1 + std::cos(std::numbers::pi * done)) / 2;
}

/// Returns the chosen rows with a little random noise on each symptom.
SymptomRows noisy(const SymptomRows& all, std::span<const std::size_t> chosen, double deviation,
                  Stream& noise) {
  SymptomRows rows(chosen.size(), SymptomRows::ColsAtCompileTime);
  for (Index i = 0; i < rows.rows(); ++i) {
    rows.row(i) = all.row(static_cast<Index>(chosen[static_cast<std::size_t>(i)]));
    for (double& symptom : rows.row(i)) symptom += noise.normal(0, deviation);
  }
  return rows;
}

void run_symptom_epoch(std::int64_t epoch, SymptomNetwork& network, const SymptomRows& rows,
                       const std::vector<Label>& all_labels, double noise_deviation,
                       const Stream& stream, Training& training) {
  Stream own = stream.child("epoch" + std::to_string(epoch));
  Stream noise = own.child("noise");
  Stream dropped = own.child("dropout");
  const std::vector<std::size_t> order = own.permutation(all_labels.size());
  constexpr auto batch = static_cast<std::size_t>(SymptomTraining::batch);
  BatchOutcome sums;
  for (std::size_t begin = 0; begin < order.size(); begin += batch) {
    const auto chosen = std::span(order).subspan(begin, std::min(batch, order.size() - begin));
    std::vector<Label> labels(chosen.size());
    std::ranges::transform(chosen, labels.begin(), [&](std::size_t i) { return all_labels[i]; });
    const BatchOutcome outcome = network.step(noisy(rows, chosen, noise_deviation, noise), labels,
                                              learning_rate_in(epoch), dropped);
    sums.loss += outcome.loss;
    sums.correct += outcome.correct;
  }
  const auto n = static_cast<double>(order.size());
  training.loss.push_back(sums.loss / n);
  training.train_accuracy.push_back(static_cast<double>(sums.correct) / n);
}

}  // namespace

Training train_on_symptoms(SymptomNetwork& network, const SymptomRows& rows,
                           const std::vector<Label>& labels, const SymptomTraining& settings,
                           const Stream& stream, const EpochDone& epoch_done) {
  Training training;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= SymptomTraining::epochs; ++epoch) {
    run_symptom_epoch(epoch, network, rows, labels, settings.noise, stream, training);
    if (epoch_done) epoch_done(epoch, training.loss.back());
  }
  training.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return training;
}

}  // namespace piae::diagnosis
