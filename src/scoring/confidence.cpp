#include "scoring/confidence.hpp"

#include <algorithm>

#include "scoring/refusal.hpp"

namespace piae::scoring {

std::vector<Judgement> judgements_of(std::span<const float> scores, std::span<const Label> named,
                                     std::span<const Label> labels) {
  std::vector<Judgement> all;
  all.reserve(labels.size());
  const std::size_t classes = scores.size() / labels.size();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    all.push_back({std::ranges::max(scores.subspan(i * classes, classes)), named[i] == labels[i]});
  }
  return all;
}

std::vector<Judgement> judgements_of(const DiagnosisRecord& record) {
  return judgements_of(record.scores, record.predictions, record.labels);
}

bool ranks_answers(std::span<const Judgement> judgements) {
  return std::ranges::any_of(
      judgements, [&](const Judgement& each) { return each.score != judgements.front().score; });
}

Confidence confidence_of(const DiagnosisRecord& record) {
  const std::vector<Judgement> judgements = judgements_of(record);
  return {
      .calibration_error = expected_calibration_error(reliability(judgements, reliability_bins)),
      .answerable = answerable_share(judgements, wanted_precision_percent),
      .ranks_answers = ranks_answers(judgements)};
}

}  // namespace piae::scoring
