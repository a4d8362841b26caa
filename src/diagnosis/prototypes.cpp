#include "diagnosis/prototypes.hpp"

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>

#include "base/columns.hpp"
#include "base/error.hpp"
#include "diagnosis/nearest_orders.hpp"
#include "diagnosis/standardise.hpp"
#include "nets/stored_parameters.hpp"

namespace piae::diagnosis {

namespace {

using Eigen::Index;

constexpr auto prototypes_dataset = "/prototypes";

const std::vector<nets::ParameterSpec>& embedding_specs() {
  static const std::vector<nets::ParameterSpec> specs =
      nets::dense_chain_specs("embedding", by_orders.columns, PrototypeTraining::embedding,
                              {.depth = 2, .width = static_cast<int>(PrototypeTraining::hidden)});
  return specs;
}

std::vector<std::vector<std::size_t>> windows_of_classes(const signal::WindowSet& training) {
  std::vector<std::vector<std::size_t>> windows_of;
  for (std::size_t c = 0; c < training.info.classes.size(); ++c) {
    windows_of.push_back(training.indices_of(static_cast<Label>(c)));
    if (windows_of.back().empty()) {
      throw Error(Exit::bad_input, "training set: class '" + training.info.classes[c].name +
                                       "' has no window, but prototypes needs one or more of each "
                                       "class; choose another --classifier");
    }
  }
  if (training.size() == windows_of.size()) {
    throw Error(Exit::bad_input,
                "training set: each class has one window, but prototypes needs two or more of a "
                "class; choose another --classifier");
  }
  return windows_of;
}

}  // namespace

Prototypes::Prototypes(std::int64_t classes, std::size_t length, const Stream& initial)
    : classes_(classes),
      length_(length),
      most_rows_(classes * static_cast<std::int64_t>(PrototypeTraining::size.shots +
                                                     PrototypeTraining::size.queries)),
      parameters_(std::make_shared<nets::Parameters<float>>(embedding_specs(), initial)),
      network_(parameters_, "embedding", most_rows_),
      prototypes_(Embeddings::Zero(classes, PrototypeTraining::embedding)) {}

Prototypes::Prototypes(const artefact::Reader& reader, const signal::DatasetInfo& info,
                       std::size_t length)
    : Prototypes(std::ssize(info.classes), length, Stream("overwritten")) {
  parameters_->write(nets::Parameters<float>::Kept::value,
                     nets::read_parameters(reader, learned, embedding_specs()));
  const auto stored = reader.numbers<double>(
      std::string(learned) + prototypes_dataset,
      {info.classes.size(), static_cast<std::size_t>(PrototypeTraining::embedding)});
  prototypes_ =
      Eigen::Map<const Embeddings>(stored.values.data(), classes_, PrototypeTraining::embedding);
}

Embeddings Prototypes::embed(const FeatureRows& rows) {
  Embeddings all(rows.rows(), PrototypeTraining::embedding);
  for (Index begin = 0; begin < rows.rows(); begin += most_rows_) {
    const Index count = std::min(most_rows_, rows.rows() - begin);
    nets::put<float>(rows.middleRows(begin, count).cast<float>().array(), network_.input());
    all.middleRows(begin, count) =
        nets::copied(network_.forward(count), count, PrototypeTraining::embedding).cast<double>();
  }
  return all;
}

void Prototypes::run_epoch(const FeatureRows& rows,
                           const std::vector<std::vector<std::size_t>>& windows_of, Stream random,
                           Training& training) {
  BatchOutcome sums;
  std::size_t queries = 0;
  Embeddings gradient;
  for (std::int64_t i = 0; i < PrototypeTraining::episodes; ++i) {
    const Episode episode = draw_episode(windows_of, PrototypeTraining::size, random);
    std::vector<std::size_t> shown = episode.support;
    shown.insert(shown.end(), episode.queries.begin(), episode.queries.end());
    const BatchOutcome outcome =
        episode_loss(episode, classes_, embed(rows(shown, every_column(rows))), gradient);
    nets::put<float>(gradient.cast<float>(), network_.output_gradient());
    (void)network_.backward_and_take(nets::AdamStep(++steps_, PrototypeTraining::learning_rate),
                                     /*by_input=*/false);
    sums.loss += outcome.loss;
    sums.correct += outcome.correct;
    queries += episode.queries.size();
  }
  training.loss.push_back(sums.loss / static_cast<double>(queries));
  training.train_accuracy.push_back(static_cast<double>(sums.correct) /
                                    static_cast<double>(queries));
}

Training Prototypes::train(const signal::WindowSet& training, const Stream& stream,
                           const EpochDone& epoch_done) {
  const std::vector<std::vector<std::size_t>> windows_of = windows_of_classes(training);
  const FeatureRows rows = order_features(training, "training set");
  Training course;
  const auto start = std::chrono::steady_clock::now();
  for (std::int64_t epoch = 1; epoch <= PrototypeTraining::epochs; ++epoch) {
    run_epoch(rows, windows_of, stream.child("epoch" + std::to_string(epoch)), course);
    if (epoch_done) epoch_done(epoch, course.loss.back());
  }
  course.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  prototypes_ = mean_embeddings(embed(rows), training.labels, classes_);
  return course;
}

Outputs Prototypes::outputs(const signal::WindowSet& windows, const std::string& what) {
  require_length(windows, length_, what);
  const Embeddings embedded = embed(order_features(windows, what));
  const nets::RowArray<float> logits = distance_logits(embedded, prototypes_).cast<float>();
  const nets::RowArray<float> hidden = embedded.cast<float>();
  Outputs all{.hidden = {hidden.data(), hidden.data() + hidden.size()},
              .logits = {logits.data(), logits.data() + logits.size()},
              .scores = std::vector<float>(static_cast<std::size_t>(logits.size()))};
  for (Index i = 0; i < logits.rows(); ++i) {
    softmax(classes_, logits.row(i).data(), all.scores.data() + i * classes_);
  }
  return all;
}

void Prototypes::write(artefact::Writer& writer) const {
  nets::write_parameters(writer, learned, embedding_specs(),
                         parameters_->read(nets::Parameters<float>::Kept::value));
  writer.numbers(
      std::string(learned) + prototypes_dataset,
      std::span<const double>(prototypes_.data(), static_cast<std::size_t>(prototypes_.size())),
      {static_cast<std::size_t>(prototypes_.rows()), static_cast<std::size_t>(prototypes_.cols())});
}

Learned train_prototypes(const signal::WindowSet& /*normal*/, const signal::WindowSet& training,
                         double /*prewhitening*/, const Stream& stream,
                         const EpochDone& epoch_done) {
  auto trained = std::make_unique<Prototypes>(std::ssize(training.info.classes), training.length,
                                              stream.child("initial"));
  Training course = trained->train(training, stream, epoch_done);
  return {.trained = std::move(trained), .training = std::move(course)};
}

std::unique_ptr<Trained> read_prototypes(const artefact::Reader& reader,
                                         const signal::DatasetInfo& info, std::size_t length) {
  return std::make_unique<Prototypes>(reader, info, length);
}

}  // namespace piae::diagnosis
