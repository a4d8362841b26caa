#include "scoring/confidence.hpp"

#include <algorithm>

#include "scoring/refusal.hpp"

namespace piae::scoring {

std::vector<Judgement> judgements_of(const DiagnosisRecord& record) {
  std::vector<Judgement> all;
  all.reserve(record.labels.size());
  const std::size_t classes = record.info.classes.size();
  for (std::size_t i = 0; i < record.labels.size(); ++i) {
    const auto own = std::span(record.scores).subspan(i * classes, classes);
    all.push_back({std::ranges::max(own), record.predictions[i] == record.labels[i]});
  }
  return all;
}

bool tells(std::span<const Judgement> judgements) {
  return std::ranges::any_of(
      judgements, [&](const Judgement& each) { return each.score != judgements.front().score; });
}

Confidence confidence_of(const DiagnosisRecord& record) {
  const std::vector<Judgement> judgements = judgements_of(record);
  return {
      .calibration_error = expected_calibration_error(reliability(judgements, reliability_bins)),
      .answerable = answerable_share(judgements, wanted_precision_percent),
      .tells = tells(judgements)};
}

}  // namespace piae::scoring
