#include "diagnosis/kept_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/random.hpp"
#include "diagnosis/learn.hpp"
#include "scoring/temperature.hpp"
#include "signal/ranges.hpp"

namespace piae::diagnosis {

namespace {

constexpr const char* reference = "/reference";
constexpr Range possible_temperature{.low = 1e-3, .high = 1e3};
constexpr Range count{.low = 0, .high = 1e9};
constexpr Range possible_window{.low = 2, .high = 1e6, .unit = " samples"};

std::size_t read_window_length(const artefact::Reader& reader) {
  return static_cast<std::size_t>(reader.integer("/", "window_length", possible_window));
}

const Classifier& read_kind_of_classifier(const artefact::Reader& reader) {
  const std::string name = reader.text("/", "classifier");
  const Classifier* const found = find_classifier(name);
  if (found == nullptr) reader.refuse("/", "has the unknown classifier '" + name + "'");
  return *found;
}

ClassifierOrigin read_origin(const artefact::Reader& reader) {
  return {.method = reader.text("/", "method"),
          .ratio = reader.text("/", "ratio"),
          .generated_per_class = reader.integer("/", "generated_per_class", count),
          .seed = reader.integer("/", "seed"),
          .protocol = signal::read_protocol(reader),
          .training_windows = reader.integer("/", "training_windows", count),
          .training_digest = reader.text("/", "training_digest")};
}

void write_origin(artefact::Writer& writer, const ClassifierOrigin& origin) {
  writer.attribute("/", "method", origin.method);
  writer.attribute("/", "ratio", origin.ratio);
  writer.attribute("/", "generated_per_class", origin.generated_per_class);
  writer.attribute("/", "seed", origin.seed);
  writer.attribute("/", "protocol", to_string(origin.protocol));
  writer.attribute("/", "training_windows", origin.training_windows);
  writer.attribute("/", "training_digest", origin.training_digest);
}

signal::WindowSet window_of_noise(const signal::DatasetInfo& info, std::size_t length) {
  Stream stream("noise");
  signal::WindowSet noise;
  noise.info = info;
  noise.length = length;
  for (std::size_t i = 0; i < length; ++i) {
    noise.samples.push_back(static_cast<float>(stream.normal(0, 1)));
  }
  noise.labels = {info.healthy_label()};
  noise.condition = {signal::every_condition};
  noise.shaft_speed_rpm = {info.tested_speed_rpm()};
  return noise;
}

std::optional<Novelty> read_novelty(const artefact::Reader& reader,
                                    const signal::DatasetInfo& info) {
  if (!reader.has(reference)) return std::nullopt;
  return Novelty(reader, reference, info);
}

}  // namespace

KeptClassifier::KeptClassifier(signal::DatasetInfo info, std::size_t length,
                               const Classifier& classifier, std::unique_ptr<Trained> trained,
                               Calibration calibration, std::optional<Novelty> novelty,
                               ClassifierOrigin origin)
    : info_(std::move(info)),
      length_(length),
      classifier_(&classifier),
      trained_(std::move(trained)),
      calibration_(calibration),
      novelty_(std::move(novelty)),
      origin_(std::move(origin)) {}

KeptClassifier::KeptClassifier(const artefact::Reader& reader)
    : info_(signal::read_dataset_info(reader)),
      length_(read_window_length(reader)),
      classifier_(&read_kind_of_classifier(reader)),
      trained_(read_learned(*classifier_, reader, info_, length_)),
      calibration_{.temperature = reader.real("/", "temperature", possible_temperature),
                   .windows = reader.integer("/", "left_out_windows", count)},
      novelty_(read_novelty(reader, info_)),
      origin_(read_origin(reader)) {
  require_prediction(reader);
}

void KeptClassifier::require_prediction(const artefact::Reader& reader) {
  Predictions predictions;
  try {
    predictions = predict(window_of_noise(info_, length_));
  } catch (const Error& error) {
    reader.refuse("/", std::string("cannot classify a window: ") + error.what());
  }
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::ranges::all_of(predictions.probabilities, is_finite) ||
      !std::ranges::all_of(predictions.novelty, is_finite)) {
    reader.refuse("/", "gives NaN or infinite outputs for a window");
  }
}

void KeptClassifier::write(artefact::Writer& writer) const {
  signal::write(writer, info_);
  writer.attribute("/", "classifier", std::string(classifier_->name));
  writer.attribute("/", "input", std::string(classifier_->input));
  writer.attribute("/", "window_length", static_cast<std::int64_t>(length_));
  writer.attribute("/", "temperature", calibration_.temperature);
  writer.attribute("/", "left_out_windows", calibration_.windows);
  write_origin(writer, origin_);
  trained_->write(writer);
  if (novelty_) novelty_->write(writer, reference);
}

Outputs KeptClassifier::uncalibrated(const signal::WindowSet& windows) {
  return trained_->outputs(windows, "windows to classify");
}

Predictions KeptClassifier::predict(const signal::WindowSet& windows) {
  Predictions predictions;
  const std::size_t classes = info_.classes.size();
  predictions.probabilities =
      scoring::tempered(uncalibrated(windows).logits, classes, calibration_.temperature);
  predictions.labels = most_likely(predictions.probabilities, classes);
  predictions.novelty = novelty_ ? novelty_->of(windows) : std::vector<double>(windows.size());
  return predictions;
}

}  // namespace piae::diagnosis
