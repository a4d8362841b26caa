#include "classification/record.hpp"

#include <string>

#include "classification/texts.hpp"

namespace piae::classification {

namespace {

void write_recordings(artefact::Writer& writer, const std::vector<Verdict>& verdicts,
                      const signal::DatasetInfo& info) {
  std::vector<std::string> names;
  std::vector<std::string> classes;
  std::vector<std::string> evidence;
  std::vector<Label> labels;
  std::vector<double> probabilities;
  std::vector<double> shares;
  std::vector<double> unknown_shares;
  std::vector<std::int32_t> unknown;
  for (const Verdict& verdict : verdicts) {
    names.push_back(verdict.recording.name);
    classes.push_back(verdict.recording.true_class);
    evidence.push_back(evidence_of(verdict, info));
    labels.push_back(verdict.label);
    probabilities.push_back(verdict.probability);
    shares.push_back(verdict.share);
    unknown_shares.push_back(verdict.share_unknown);
    unknown.push_back(verdict.unknown ? 1 : 0);
  }
  writer.strings("/recordings/name", names);
  writer.strings("/recordings/class", classes);
  writer.strings("/recordings/evidence", evidence);
  writer.numbers("/recordings/label", labels);
  writer.numbers("/recordings/probability", probabilities);
  writer.numbers("/recordings/share", shares);
  writer.numbers("/recordings/share_unknown", unknown_shares);
  writer.numbers("/recordings/unknown", unknown);
}

void write_windows(artefact::Writer& writer, const std::vector<Verdict>& verdicts,
                   std::size_t classes) {
  std::vector<std::int32_t> recordings;
  std::vector<double> starts_s;
  std::vector<Label> labels;
  std::vector<float> probabilities;
  std::vector<double> novelty;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Verdict& verdict = verdicts[i];
    const diagnosis::Predictions& predictions = verdict.predictions;
    recordings.insert(recordings.end(), verdict.start_s.size(), static_cast<std::int32_t>(i));
    starts_s.insert(starts_s.end(), verdict.start_s.begin(), verdict.start_s.end());
    labels.insert(labels.end(), predictions.labels.begin(), predictions.labels.end());
    probabilities.insert(probabilities.end(), predictions.probabilities.begin(),
                         predictions.probabilities.end());
    novelty.insert(novelty.end(), predictions.novelty.begin(), predictions.novelty.end());
  }
  writer.numbers("/windows/recording", recordings);
  writer.numbers("/windows/start_s", starts_s);
  writer.numbers("/windows/label", labels);
  writer.numbers("/windows/probabilities", probabilities, {labels.size(), classes});
  writer.numbers("/windows/strangeness", novelty);
}

}  // namespace

void write(artefact::Writer& writer, const std::vector<Verdict>& verdicts,
           const diagnosis::KeptClassifier& classifier, const std::string& classifier_digest) {
  signal::write(writer, classifier.info());
  writer.attribute("/", "classifier", std::string(classifier.classifier().name));
  writer.attribute("/", "classifier_digest", classifier_digest);
  write_recordings(writer, verdicts, classifier.info());
  write_windows(writer, verdicts, classifier.info().classes.size());
}

void require_classification(const artefact::Reader& reader) {
  const signal::DatasetInfo info = signal::read_dataset_info(reader);
  (void)reader.text("/", "classifier");
  (void)reader.text("/", "classifier_digest");
  const std::size_t recordings = reader.strings("/recordings/name").size();
  for (const std::string path : {"/recordings/class", "/recordings/evidence"}) {
    if (reader.strings(path).size() != recordings) {
      reader.refuse(path, "is not as long as /recordings/name");
    }
  }
  const auto require_labels = [&](const std::string& path, std::size_t n) {
    for (const Label label : reader.numbers<Label>(path, {n}).values) {
      if (label < 0 || index_of(label) >= info.classes.size()) {
        reader.refuse(path, "has a label without a class");
      }
    }
  };
  require_labels("/recordings/label", recordings);
  for (const std::string name : {"probability", "share", "share_unknown"}) {
    const std::string path = "/recordings/" + name;
    reader.require_all(path, reader.numbers<double>(path, {recordings}).values,
                       {.low = 0, .high = 1});
  }
  for (const std::int32_t unknown :
       reader.numbers<std::int32_t>("/recordings/unknown", {recordings}).values) {
    if (unknown != 0 && unknown != 1)
      reader.refuse("/recordings/unknown", "must hold 0 and 1 only");
  }
  const auto of_window = reader.numbers<std::int32_t>("/windows/recording", {0}).values;
  for (const std::int32_t recording : of_window) {
    if (recording < 0 || static_cast<std::size_t>(recording) >= recordings) {
      reader.refuse("/windows/recording", "has an index without a recording");
    }
  }
  require_labels("/windows/label", of_window.size());
  for (const std::string path : {"/windows/start_s", "/windows/strangeness"}) {
    reader.require_all(path, reader.numbers<double>(path, {of_window.size()}).values,
                       {.low = 0, .high = artefact::finite.high});
  }
  const std::string path = "/windows/probabilities";
  const auto probabilities = reader.numbers<float>(path, {of_window.size(), info.classes.size()});
  const std::vector<double> values(probabilities.values.begin(), probabilities.values.end());
  reader.require_all(path, values, {.low = 0, .high = 1});
}

std::vector<Named> read_named(const artefact::Reader& reader) {
  require_classification(reader);
  const signal::DatasetInfo info = signal::read_dataset_info(reader);
  const std::vector<std::string> names = reader.strings("/recordings/name");
  const std::vector<std::string> classes = reader.strings("/recordings/class");
  const std::vector<std::string> evidence = reader.strings("/recordings/evidence");
  const auto shares = reader.numbers<double>("/recordings/share", {names.size()}).values;
  const auto labels = reader.numbers<Label>("/recordings/label", {names.size()}).values;
  const auto unknown = reader.numbers<std::int32_t>("/recordings/unknown", {names.size()}).values;
  std::vector<Named> named;
  for (std::size_t i = 0; i < names.size(); ++i) {
    named.push_back({.recording = names[i],
                     .true_class = classes[i],
                     .fault = unknown[i] == 1 ? "unknown" : info.class_of(labels[i]).name,
                     .evidence = evidence[i],
                     .share = shares[i]});
  }
  return named;
}

}  // namespace piae::classification
