#include "diagnosis/line_rules.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "diagnosis/cross_entropy.hpp"
#include "diagnosis/fault_types.hpp"
#include "symptoms/measures.hpp"

namespace piae::diagnosis {

namespace {

using signal::DatasetInfo;
using signal::Defect;

constexpr double threshold = 5;

/// Returns the class that rule `exclusion` predicts.
Label excluded(const DatasetInfo& info, const std::vector<float>& evidence) {
  const std::vector<Label> faults = info.fault_labels();
  const auto ball = std::ranges::find(faults, Defect::roller,
                                      [&](Label label) { return info.class_of(label).defect; });
  if (ball != faults.end()) return *ball;
  return *std::ranges::max_element(faults, {},
                                   [&](Label label) { return evidence[index_of(label)]; });
}

symptoms::Baselines baselines_of(const signal::WindowSet& normal, double prewhitening) {
  require_fault_types(normal.info);
  return {normal, symptoms::measure(normal, "--normal", prewhitening), prewhitening};
}

}  // namespace

std::vector<float> evidence(const DatasetInfo& info, const Findings& findings, Rule rule) {
  std::vector<float> evidence(info.classes.size(), static_cast<float>(threshold));
  double greatest = 0;
  for (const Label label : info.fault_labels()) {
    const double excess = findings.excesses.at(place_among_types(info.class_of(label).defect));
    evidence[index_of(label)] = static_cast<float>(excess);
    greatest = std::max(greatest, excess);
  }
  if (rule == Rule::exclusion && greatest <= threshold && findings.novelty > 1) {
    evidence[index_of(excluded(info, evidence))] = static_cast<float>(threshold * findings.novelty);
  }
  return evidence;
}

TrainedRule::TrainedRule(const signal::WindowSet& normal, Rule rule, double prewhitening)
    : rule_(rule), baselines_(baselines_of(normal, prewhitening)) {}

TrainedRule::TrainedRule(const artefact::Reader& reader, const DatasetInfo& info, Rule rule)
    : rule_(rule), baselines_(symptoms::Baselines::read(reader, learned, info.sample_rate_hz)) {}

Outputs TrainedRule::outputs(const signal::WindowSet& windows, const std::string& what) {
  const std::vector<symptoms::Measures> tested =
      symptoms::measure(windows, what, baselines_.prewhitening());
  const std::size_t classes = windows.info.classes.size();
  Outputs all;
  all.scores.resize(windows.size() * classes);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const symptoms::Baseline& baseline = baselines_.at(windows.speed_rpm(i));
    const Findings findings{.excesses = baseline.excesses(tested[i]),
                            .novelty = baseline.novelty().of(tested[i].shape_db)};
    const std::vector<float> logits = evidence(windows.info, findings, rule_);
    softmax(static_cast<std::int64_t>(classes), logits.data(), all.scores.data() + i * classes);
    all.logits.insert(all.logits.end(), logits.begin(), logits.end());
  }
  return all;
}

void TrainedRule::write(artefact::Writer& writer) const { baselines_.write(writer, learned); }

}  // namespace piae::diagnosis
