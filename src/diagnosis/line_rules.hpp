#pragma once

#include <array>
#include <memory>
#include <vector>

#include "artefact/reader.hpp"
#include "diagnosis/classifier.hpp"
#include "signal/window_set.hpp"
#include "symptoms/baseline.hpp"
#include "symptoms/measures.hpp"

namespace piae::diagnosis {

// Two rules that find the fault type from healthy windows alone, without known or generated fault
// windows. They automate what an analyst does by hand.

/// Comparison of one window with healthy windows of its speed (symptoms/baseline.hpp).
struct Findings {
  /// Height of each fault type's line above the healthy mean, in standard deviations.
  std::array<double, symptoms::number_of_fault_types> excesses{};
  double novelty = 0;  ///< divided by its threshold: more than 1 is new
};

enum class Rule {
  /// The highest line gives the fault type, if it exceeds 5 deviations; otherwise the window is
  /// healthy. The height is a maximum over slips, so for healthy windows it has about a Gumbel
  /// distribution, which exceeds its mean by 5 deviations with probability 0.09 %.
  envelope,
  /// Like `envelope`, but a new window without a line is a ball defect if the task has such a
  /// class, otherwise the fault type with the highest line. A ball spins freely, so its defect
  /// meets the races only now and then, and rarely shows its line; Smith and Randall (2015) found
  /// this in most of CWRU's records of ball defects.
  exclusion
};

/// Returns the evidence for each class of a data set, in deviations; the greatest gives the class.
/// The evidence is the excess for a fault type, 5 for healthy, and 5 times the novelty for the
/// class that rule `exclusion` predicts.
std::vector<float> evidence(const signal::DatasetInfo& info, const Findings& findings, Rule rule);

/// A rule with its healthy reference windows.
class TrainedRule final : public Trained {
 public:
  /// Throws Error(bad_input) if several classes have the same fault type, because a line cannot
  /// tell them apart, and as symptoms::measure() and symptoms::Baselines do.
  TrainedRule(const signal::WindowSet& normal, Rule rule, double prewhitening);
  TrainedRule(const artefact::Reader& reader, const signal::DatasetInfo& info, Rule rule);

  /// Returns the evidence as logits.
  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  Rule rule_;
  symptoms::Baselines baselines_;
};

template <Rule rule>
Learned learn_rule(const signal::WindowSet& normal, const signal::WindowSet& /*training*/,
                   double prewhitening, const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<TrainedRule>(normal, rule, prewhitening), .training = {}};
}

template <Rule rule>
std::unique_ptr<Trained> read_rule(const artefact::Reader& reader, const signal::DatasetInfo& info,
                                   std::size_t /*length*/) {
  return std::make_unique<TrainedRule>(reader, info, rule);
}

/// Chosen on seeds 100 to 104: docs/any-bearing.md, "Which band?".
inline constexpr double prewhitening_of_rules = 0.5;

inline constexpr Classifier envelope_rule{
    .name = "envelope-rule",
    .what = "fault lines compared with healthy windows, untrained",
    .input = "the envelope spectrum over orders of the shaft",
    .rule = true,
    .slowest = slowest_of_symptoms,
    .fastest = fastest_of_symptoms,
    .prewhitening = prewhitening_of_rules,
    .learn = learn_rule<Rule::envelope>,
    .read = read_rule<Rule::envelope>};
inline constexpr Classifier exclusion_rule{
    .name = "exclusion-rule",
    .what = "the same, and a changed spectrum without a fault line is a ball fault",
    .input = "the envelope spectrum over orders of the shaft and the log power in 48 bands",
    .rule = true,
    .slowest = slowest_of_symptoms,
    .fastest = fastest_of_symptoms,
    .prewhitening = prewhitening_of_rules,
    .learn = learn_rule<Rule::exclusion>,
    .read = read_rule<Rule::exclusion>};

}  // namespace piae::diagnosis
