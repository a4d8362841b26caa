#include "diagnosis/symptom_net.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

namespace piae::diagnosis {

namespace {

using Eigen::Index;

double learning_rate_in(std::int64_t epoch) {
  const double done = static_cast<double>(epoch - 1) / static_cast<double>(SymptomTraining::epochs);
  return SymptomTraining::learning_rate * (1 + std::cos(std::numbers::pi * done)) / 2;
}

/// Returns the chosen rows with a little random noise on each symptom.
SymptomRows noisy(const SymptomRows& all, std::span<const std::size_t> chosen, Stream& noise) {
  SymptomRows rows(chosen.size(), SymptomRows::ColsAtCompileTime);
  for (Index i = 0; i < rows.rows(); ++i) {
    rows.row(i) = all.row(static_cast<Index>(chosen[static_cast<std::size_t>(i)]));
    for (double& symptom : rows.row(i)) symptom += noise.normal(0, SymptomTraining::noise);
  }
  return rows;
}

}  // namespace

SymptomNet::SymptomNet(const artefact::Reader& reader, const signal::DatasetInfo& info)
    : SymptomNet(SymptomScale(reader, learned, info.sample_rate_hz), std::ssize(info.classes),
                 Stream("overwritten")) {
  network_.read(reader, learned);
}

void SymptomNet::run_epoch(std::int64_t epoch, const Stream& stream, Training& training) {
  const std::vector<Label>& all_labels = scale_.labels();
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
    const BatchOutcome outcome = network_.step(noisy(scale_.training(), chosen, noise), labels,
                                               learning_rate_in(epoch), dropped);
    sums.loss += outcome.loss;
    sums.correct += outcome.correct;
  }
  const auto n = static_cast<double>(order.size());
  training.loss.push_back(sums.loss / n);
  training.train_accuracy.push_back(static_cast<double>(sums.correct) / n);
}

Training SymptomNet::train(const Stream& stream, const EpochDone& epoch_done) {
  Training training;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= SymptomTraining::epochs; ++epoch) {
    run_epoch(epoch, stream, training);
    if (epoch_done) epoch_done(epoch, training.loss.back());
  }
  training.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return training;
}

Outputs SymptomNet::outputs(const signal::WindowSet& windows, const std::string& what) {
  const SymptomRows rows = scale_.rows_of(windows, what);
  Outputs all;
  for (Index i = 0; i < rows.rows(); ++i) {
    const SymptomNetwork::Outputs outputs = network_.outputs(rows.row(i));
    std::vector<float> logits(outputs.logits.data(), outputs.logits.data() + classes_);
    std::vector<float> scores(logits.size());
    softmax(classes_, logits.data(), scores.data());
    all.hidden.insert(all.hidden.end(), outputs.hidden.data(),
                      outputs.hidden.data() + SymptomNetwork::hidden);
    all.logits.insert(all.logits.end(), logits.begin(), logits.end());
    all.scores.insert(all.scores.end(), scores.begin(), scores.end());
  }
  return all;
}

void SymptomNet::write(artefact::Writer& writer) const {
  scale_.write(writer, learned);
  network_.write(writer, learned);
}

Learned train_symptom_net(const signal::WindowSet& normal, const signal::WindowSet& training,
                          const Stream& stream, const EpochDone& epoch_done) {
  auto net = std::make_unique<SymptomNet>(
      SymptomScale(normal, training), std::ssize(training.info.classes), stream.child("initial"));
  Training course = net->train(stream, epoch_done);
  return {.trained = std::move(net), .training = std::move(course)};
}

std::unique_ptr<Trained> read_symptom_net(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t /*length*/) {
  return std::make_unique<SymptomNet>(reader, info);
}

}  // namespace piae::diagnosis
