#pragma once

#include <string>
#include <vector>

#include "report/labels.hpp"
#include "report/recommendation.hpp"
#include "scoring/recall.hpp"

namespace piae::report {

/// Of percents and their intervals.
inline constexpr NumberStyle percent_style{.decimals = 1};

/// What an effort takes, for tables: "windows + classifier".
std::string effort_label(Effort effort);

/// "shift"; "shift by nearest" where the run has several classifiers.
std::string name_of(const Candidate& candidate, const Recommendation& of);

/// "3.2" percent, or no_number where there was no such window.
std::string share_label(const scoring::Share& share);

/// "-3.2" points; no_number for the best itself.
std::string behind_label(const Candidate& candidate);
/// Holm's p; no_number where nothing is asked.
std::string holm_label(const Candidate& candidate);

/// What is recommended, why, what it costs and what it gets wrong, a sentence or two each. All
/// numbers are those of the run; how long it took differs from run to run, and stands elsewhere.
std::vector<std::string> recommendation_sentences(const Recommendation& recommendation);

/// What is not compared with the others; empty where all are.
std::string not_compared_note(const Recommendation& recommendation);

}  // namespace piae::report
