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

// Two rules that name the kind of a defect from healthy windows alone: no fault window is known,
// and none is generated. They do by machine what an analyst does by hand.

/// What one window shows against healthy windows of its speed (symptoms/baseline.hpp).
struct Findings {
  /// By how many standard deviations the line of each kind stands above the healthy mean.
  std::array<double, symptoms::number_of_kinds> excesses{};
  double novelty = 0;  ///< by its threshold: more than 1 is new
};

enum class Rule {
  /// The line that stands out most names the kind, if by more than 5 deviations; else the window is
  /// healthy. The height is a maximum over slips, so for healthy windows it has about Gumbel's
  /// distribution, which exceeds its mean by 5 deviations with the chance 0.09 %.
  envelope,
  /// The same; but a window that is new and shows no line is a ball defect, where the task has a
  /// class of these, else the kind whose line stands out most. A ball spins freely, so its defect
  /// now strikes the races and now does not, and is the one that rarely shows its line; Smith and
  /// Randall (2015) found so in most of CWRU's records of ball defects.
  exclusion
};

/// The evidence for each class of a data set, in deviations; the greatest names the class. That for
/// a kind is its excess, that for healthy 5, and that for what exclusion names 5 times the novelty.
std::vector<float> evidence(const signal::DatasetInfo& info, const Findings& findings, Rule rule);

/// A rule with the healthy windows that it compares others with.
class TrainedRule final : public Trained {
 public:
  /// Throws Error(bad_input) where a data set has several classes of one kind of defect, between
  /// which a line does not tell, and as symptoms::measure() and symptoms::Baselines do.
  TrainedRule(const signal::WindowSet& normal, Rule rule);
  TrainedRule(const artefact::Reader& reader, const signal::DatasetInfo& info, Rule rule);

  /// Logits are the evidence.
  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  Rule rule_;
  symptoms::Baselines baselines_;
};

template <Rule rule>
Learned learn_rule(const signal::WindowSet& normal, const signal::WindowSet& /*training*/,
                   const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<TrainedRule>(normal, rule), .training = {}};
}

template <Rule rule>
std::unique_ptr<Trained> read_rule(const artefact::Reader& reader, const signal::DatasetInfo& info,
                                   std::size_t /*length*/) {
  return std::make_unique<TrainedRule>(reader, info, rule);
}

inline constexpr Classifier envelope_rule{
    .name = "envelope-rule",
    .what = "fault lines against healthy windows, without any training",
    .input = "the envelope spectrum over orders of the shaft",
    .rule = true,
    .learn = learn_rule<Rule::envelope>,
    .read = read_rule<Rule::envelope>};
inline constexpr Classifier exclusion_rule{
    .name = "exclusion-rule",
    .what = "the same; and a change without a line is a ball",
    .input = "the envelope spectrum over orders of the shaft and the log power in 48 bands",
    .rule = true,
    .learn = learn_rule<Rule::exclusion>,
    .read = read_rule<Rule::exclusion>};

}  // namespace piae::diagnosis
