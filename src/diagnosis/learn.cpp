#include "diagnosis/learn.hpp"

#include <spdlog/fmt/fmt.h>

#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/range.hpp"
#include "diagnosis/adapting.hpp"
#include "diagnosis/any_bearing.hpp"
#include "diagnosis/one_core_backend.hpp"
#include "diagnosis/wdcnn.hpp"
#include "diagnosis/wdcnn_evaluation.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

namespace {

constexpr const char* input_length = "input_length";
constexpr Range possible_length{.low = WdcnnLayers::shortest_window, .high = 1e6};

/// A trained WDCNN with the function that makes its input.
class WdcnnOfWindows final : public Trained {
 public:
  /// Takes a network; `length` is the length of its input.
  WdcnnOfWindows(std::unique_ptr<Wdcnn> network, std::size_t length, Represent represent)
      : network_(std::move(network)), length_(length), represent_(represent) {}

  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override {
    return predict_by_wdcnn(*network_, length_, represent_(windows, what));
  }
  void write(artefact::Writer& writer) const override {
    diagnosis::write(writer, learned, network_->weights());
    writer.attribute(learned, input_length, static_cast<std::int64_t>(length_));
  }

 private:
  std::unique_ptr<Wdcnn> network_;
  std::size_t length_;
  Represent represent_;
};

/// Returns the back end of a WDCNN. One that adapts also gets the windows without labels.
MakeWdcnnBackend back_end_of(const Classifier& classifier, const signal::WindowSet& normal,
                             const LearningSettings& settings, const Stream& stream) {
  if (!classifier.adapts()) return settings.make_backend;
  const signal::WindowSet windows = without_labels(normal, *settings.unlabelled);
  return adapting_backend({.adaptation = classifier.adaptation,
                           .unlabelled = classifier.represent(windows, "--unlabelled").samples,
                           .stream = stream});
}

Learned fitted(const Classifier& classifier, const artefact::Reader* network,
               const signal::WindowSet& normal) {
  if (network == nullptr) {
    throw Error(Exit::usage, fmt::format("--classifier {} needs --network, such as {}",
                                         classifier.name, any_bearing_file));
  }
  return {.trained = classifier.fit(*network, normal), .training = {}};
}

}  // namespace

Learned learn(const Classifier& classifier, const signal::WindowSet& normal,
              const signal::WindowSet& training, const LearningSettings& settings,
              const Stream& stream, const EpochDone& epoch_done) {
  const std::string name = classifier.name;
  // Keep the original stream name of the paper's classifier so that stored results stay
  // reproducible.
  const Stream own = name == scoring::paper_classifier ? stream : stream.child(name);
  if (classifier.fit != nullptr) return fitted(classifier, settings.network, normal);
  if (classifier.learn != nullptr) {
    const double prewhitening = settings.prewhitening.value_or(classifier.prewhitening.value_or(0));
    return classifier.learn(normal, training, prewhitening, own, epoch_done);
  }
  LabelledWindows shown = classifier.represent(training, "training set");
  const std::size_t length = shown.length;
  TrainedWdcnn wdcnn = train_wdcnn(std::move(shown), settings.wdcnn, own,
                                   back_end_of(classifier, normal, settings, own), epoch_done);
  return {.trained = std::make_unique<WdcnnOfWindows>(std::move(wdcnn.network), length,
                                                      classifier.represent),
          .training = std::move(wdcnn.training)};
}

std::unique_ptr<Trained> read_learned(const Classifier& classifier, const artefact::Reader& reader,
                                      const signal::DatasetInfo& info, std::size_t length) {
  if (classifier.read != nullptr) return classifier.read(reader, info, length);
  const std::int64_t shown = reader.integer(learned, input_length, possible_length);
  return std::make_unique<WdcnnOfWindows>(
      wdcnn_of(read_wdcnn_weights(reader, learned, shown,
                                  static_cast<std::int64_t>(info.classes.size()))),
      static_cast<std::size_t>(shown), classifier.represent);
}

std::int64_t epochs_of(const Classifier& classifier, const WdcnnOptions& options) {
  return classifier.represent != nullptr ? options.epochs : classifier.own_epochs;
}

}  // namespace piae::diagnosis
