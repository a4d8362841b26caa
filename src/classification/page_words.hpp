#pragma once

#include <array>
#include <string>
#include <vector>

#include "classification/line_evidence.hpp"
#include "classification/verdict.hpp"

namespace piae::classification {

/// Returns the place of a bearing's defect: "outer race", "inner race" or "ball".
std::string place_of(signal::Defect fault_type);

/// Returns a heading such as "Fault of the inner race".
std::string verdict_heading(const Verdict& verdict, const signal::DatasetInfo& info);

/// Returns sentences about the classifier's certainty.
std::string certainty_sentences(const Verdict& verdict, bool is_calibrated);

/// Returns paragraphs about what the envelope spectrum shows, in words of ISO 13373: whether it
/// supports the verdict.
std::vector<std::string> reasons_of(const Verdict& verdict, const signal::DatasetInfo& info,
                                    const std::array<LineEvidence, 3>& evidence);

/// Returns what to do next, in order. Promises nothing about the severity.
std::vector<std::string> next_steps_of(const Verdict& verdict, const signal::DatasetInfo& info);

}  // namespace piae::classification
