#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/recommendation.hpp"

namespace piae::report {

/// "shift"; "shift by nearest" where the run has several classifiers.
std::string name_of(const Candidate& candidate, const Recommendation& of);

/// What is recommended, why, what it costs and what it gets wrong, a sentence or two each. All
/// numbers are those of the run; how long it took differs from run to run, and stands elsewhere.
std::vector<std::string> recommendation_sentences(const Recommendation& recommendation);

/// What is recommended with the most generated windows, why, and what of each class it recognises;
/// and what is recommended at each ratio, where there are several. None where there is nothing.
std::vector<Section> recommendation_sections(const std::vector<Recommendation>& all);

/// recommendation.csv: dataset,ratio,effort,method,classifier,seeds,mean,std,ci95_low,ci95_high,
/// behind,p_holm,missed_faults,false_alarms,best,recommended: a line for each effort at each ratio,
/// in percent and points; the last two are 0 or 1. Empty is what is not known or not asked.
std::string recommendation_csv(const std::vector<Recommendation>& all);

}  // namespace piae::report
