#include "scoring/diagnosis_record.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "scoring/ratios.hpp"
#include "signal/ranges.hpp"
#include "signal/roles.hpp"

namespace piae::scoring {

namespace {

constexpr Range generated_per_class{.low = 0, .high = 1e9};
constexpr const char* known_per_class = "known_per_class";
constexpr Range no_window{.low = 0, .high = 0};
constexpr Range true_ratios{.low = 0, .high = 1e9};
constexpr Range windows_per_second{.low = 0, .high = 1e12};
constexpr Range cross_entropy{.low = 0, .high = 1e30};
/// Allows for rounding.
constexpr Range share{.low = -1e-6, .high = 1 + 1e-6};

std::vector<Label> read_labels(const artefact::Reader& reader, const std::string& path,
                               std::size_t count, std::size_t classes) {
  std::vector<Label> labels = reader.numbers<Label>(path, {count}).values;
  if (labels.empty()) reader.refuse(path, "is empty");
  for (const Label label : labels) {
    if (label < 0 || index_of(label) >= classes) {
      reader.refuse(path, "holds class " + std::to_string(label) +
                              ", but the data set has classes 0 to " + std::to_string(classes - 1));
    }
  }
  return labels;
}

std::string read_ratio(const artefact::Reader& reader) {
  std::string name = reader.text("/", "ratio");
  if (std::ranges::find(all_ratios(), name, &Ratio::name) == all_ratios().end()) {
    reader.refuse("/, attribute ratio", "must be one of " + list_of_ratios());
  }
  return name;
}

std::string read_classifier(const artefact::Reader& reader) {
  std::string name = reader.text("/", "classifier");
  if (!signal::ranges::is_plain_name(name)) {
    reader.refuse("/, attribute classifier", signal::ranges::plain_name_rule);
  }
  return name;
}

void require_consistent(const artefact::Reader& reader, const DiagnosisRecord& record) {
  const std::size_t classes = record.info.classes.size();
  const Confusion stored{classes,
                         reader.numbers<std::int64_t>("/confusion", {classes, classes}).values};
  if (stored != record.confusion()) {
    reader.refuse("/confusion", "is not the confusion matrix of /labels and /predictions");
  }
  if (reader.real("/", "accuracy") != accuracy(stored)) {
    reader.refuse("/, attribute accuracy", "is not the accuracy of /confusion");
  }
}

void write_features(artefact::Writer& writer, const Features& features, std::size_t n,
                    std::size_t classes) {
  writer.numbers("/features/hidden", features.hidden, {n, n == 0 ? 0 : features.hidden.size() / n});
  writer.numbers("/features/output", features.output, {n, classes});
}

Features read_features(const artefact::Reader& reader, std::size_t n, std::size_t classes) {
  return {.hidden = reader.numbers<float>("/features/hidden", {n, 0}).values,
          .output = reader.numbers<float>("/features/output", {n, classes}).values};
}

}  // namespace

void write(artefact::Writer& writer, const DiagnosisRecord& record) {
  const std::size_t n = record.labels.size();
  const std::size_t classes = record.info.classes.size();
  if (record.loss.size() != record.train_accuracy.size()) {
    throw std::logic_error("the curves of a diagnosis differ in length");
  }
  signal::write(writer, record.info);
  writer.attribute("/", "method", record.method);
  // The paper's classifier is not named, so that its artefacts stay the same as before others
  // existed.
  if (record.classifier != paper_classifier) {
    writer.attribute("/", "classifier", record.classifier);
  }
  writer.attribute("/", "ratio", record.ratio);
  writer.attribute("/", "generated_per_class", record.generated_per_class);
  if (record.true_ratio) writer.attribute("/", "true_ratio", *record.true_ratio);
  // `known_per_class` is written only without known fault windows, so that older artefacts stay
  // valid.
  if (!record.any_known) writer.attribute("/", known_per_class, std::int64_t{0});
  writer.attribute("/", "seed", record.seed);
  writer.attribute("/", "protocol", to_string(record.protocol));
  writer.attribute("/", "accuracy", record.accuracy());
  if (record.train_windows_per_second) {
    writer.attribute("/", "train_windows_per_second", *record.train_windows_per_second);
  }
  writer.numbers("/labels", record.labels);
  writer.numbers("/predictions", record.predictions);
  writer.numbers("/confusion", record.confusion().counts, {classes, classes});
  writer.numbers("/scores", record.scores, {n, classes});
  writer.numbers("/curves/loss", record.loss);
  writer.numbers("/curves/train_accuracy", record.train_accuracy);
  if (record.features) write_features(writer, *record.features, n, classes);
}

DiagnosisRecord read_diagnosis(const artefact::Reader& reader) {
  DiagnosisRecord record;
  record.info = signal::read_dataset_info(reader);
  const std::size_t classes = record.info.classes.size();
  record.method = signal::read_method(reader);
  if (reader.has_attribute("/", "classifier")) {
    record.classifier = read_classifier(reader);
  }
  record.ratio = read_ratio(reader);
  record.generated_per_class = reader.integer("/", "generated_per_class", generated_per_class);
  if (reader.has_attribute("/", known_per_class)) {
    (void)reader.integer("/", known_per_class, no_window);
    record.any_known = false;
  }
  if (record.any_known || record.generated_per_class > 0) {
    record.true_ratio = reader.real("/", "true_ratio", true_ratios);
  }
  record.seed = reader.integer("/", "seed", signal::ranges::seed);
  record.protocol = signal::read_protocol(reader);
  record.labels = read_labels(reader, "/labels", 0, classes);
  record.predictions = read_labels(reader, "/predictions", record.labels.size(), classes);
  record.scores = reader.numbers<float>("/scores", {record.labels.size(), classes}).values;
  const std::vector<double> scores(record.scores.begin(), record.scores.end());
  reader.require_all("/scores", scores, share);
  record.loss = reader.numbers<double>("/curves/loss", {0}).values;
  reader.require_all("/curves/loss", record.loss, cross_entropy);
  record.train_accuracy =
      reader.numbers<double>("/curves/train_accuracy", {record.loss.size()}).values;
  reader.require_all("/curves/train_accuracy", record.train_accuracy, share);
  if (reader.has_attribute("/", "train_windows_per_second")) {
    record.train_windows_per_second =
        reader.real("/", "train_windows_per_second", windows_per_second);
  }
  if (reader.has("/features")) {
    record.features = read_features(reader, record.labels.size(), classes);
  }
  require_consistent(reader, record);
  return record;
}

}  // namespace piae::scoring
