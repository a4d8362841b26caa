#include "diagnosis/trust.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <vector>

#include "scoring/auroc.hpp"
#include "scoring/confidence.hpp"

namespace piae::diagnosis {

namespace {

constexpr Range share{.low = 0, .high = 1};

double calibration_error_of(const std::vector<scoring::Judgement>& judgements) {
  return scoring::expected_calibration_error(
      scoring::reliability(judgements, scoring::reliability_bins));
}

double share_unknown(std::span<const double> novelty) {
  return static_cast<double>(
             std::ranges::count_if(novelty, [](double s) { return s > highest_known_novelty; })) /
         static_cast<double>(novelty.size());
}

Trust::Untrained untrained(const Novelty& novelty, const signal::WindowSet& test, Label label) {
  const std::vector<double> all = novelty.without(label).of(test);
  std::vector<double> own;
  std::vector<double> others;
  for (std::size_t i = 0; i < test.size(); ++i) {
    (test.labels[i] == label ? own : others).push_back(all[i]);
  }
  return {.auroc = scoring::auroc(others, own), .called_unknown = share_unknown(own)};
}

}  // namespace

Trust trust_in(KeptClassifier& kept, const signal::WindowSet& test) {
  const Predictions predictions = kept.predict(test);
  const std::vector<scoring::Judgement> judgements =
      scoring::judgements_of(predictions.probabilities, predictions.labels, test.labels);
  Trust trust;
  trust.accuracy =
      static_cast<double>(std::ranges::count(judgements, true, &scoring::Judgement::right)) /
      static_cast<double>(judgements.size());
  trust.calibration_error = calibration_error_of(judgements);
  trust.raw_calibration_error = calibration_error_of(
      scoring::judgements_of(kept.uncalibrated(test).scores, predictions.labels, test.labels));
  trust.called_unknown = share_unknown(predictions.novelty);
  if (!kept.novelty()) return trust;
  for (const Label label : test.info.fault_labels()) {
    trust.untrained.emplace(label, untrained(*kept.novelty(), test, label));
  }
  return trust;
}

std::string summary_of(const KeptClassifier& kept, const Trust& trust) {
  return fmt::format(
      "{} with temperature {:.2f} from {} left-out windows: calibration error {:.1f} % on the test "
      "windows, {:.1f} % of them called unknown",
      kept.classifier().name, kept.calibration().temperature, kept.calibration().windows,
      100 * trust.calibration_error, 100 * trust.called_unknown);
}

void write(artefact::Writer& writer, const Trust& trust) {
  writer.group("/trust");
  writer.attribute("/trust", "accuracy", trust.accuracy);
  writer.attribute("/trust", "raw_calibration_error", trust.raw_calibration_error);
  writer.attribute("/trust", "calibration_error", trust.calibration_error);
  writer.attribute("/trust", "called_unknown", trust.called_unknown);
  if (trust.untrained.empty()) return;
  std::vector<Label> labels;
  std::vector<double> aurocs;
  std::vector<double> called_unknown;
  for (const auto& [label, of_class] : trust.untrained) {
    labels.push_back(label);
    aurocs.push_back(of_class.auroc);
    called_unknown.push_back(of_class.called_unknown);
  }
  writer.numbers("/trust/untrained_class", labels);
  writer.numbers("/trust/untrained_auroc", aurocs);
  writer.numbers("/trust/untrained_called_unknown", called_unknown);
}

Trust read_trust(const artefact::Reader& reader, const signal::DatasetInfo& info) {
  Trust trust{.accuracy = reader.real("/trust", "accuracy", share),
              .raw_calibration_error = reader.real("/trust", "raw_calibration_error", share),
              .calibration_error = reader.real("/trust", "calibration_error", share),
              .called_unknown = reader.real("/trust", "called_unknown", share),
              .untrained = {}};
  if (!reader.has("/trust/untrained_class")) return trust;
  const auto labels = reader.numbers<Label>("/trust/untrained_class", {0}).values;
  if (labels != info.fault_labels()) {
    reader.refuse("/trust/untrained_class", "must name each fault class once, in ascending order");
  }
  const auto read = [&](const std::string& path) {
    auto values = reader.numbers<double>(path, {labels.size()}).values;
    reader.require_all(path, values, share);
    return values;
  };
  const std::vector<double> aurocs = read("/trust/untrained_auroc");
  const std::vector<double> called_unknown = read("/trust/untrained_called_unknown");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    trust.untrained[labels[i]] = {.auroc = aurocs[i], .called_unknown = called_unknown[i]};
  }
  return trust;
}

}  // namespace piae::diagnosis
