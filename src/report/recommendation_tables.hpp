#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/recommendation.hpp"

namespace piae::report {

/// Returns "shift", or "shift by nearest" if the run has several classifiers.
std::string name_of(const Candidate& candidate, const Recommendation& of);

/// Returns sentences on what is recommended, why, its cost and its errors. All numbers come from
/// the run. Durations are left out, because they differ from run to run.
std::vector<std::string> recommendation_sentences(const Recommendation& recommendation);

/// Returns the recommendation with the most generated windows, its reason and its recall by class;
/// also the recommendation at each ratio if there are several. Returns no section if there is
/// nothing to recommend.
std::vector<Section> recommendation_sections(const std::vector<Recommendation>& all);

/// Returns recommendation.csv:
/// dataset,ratio,effort,method,classifier,seeds,mean,std,ci95_low,ci95_high,
/// behind,p_holm,missed_faults,false_alarms,best,recommended: a line for each effort at each ratio,
/// in percent and points. The last two are 0 or 1. Unknown or untested numbers are empty.
std::string recommendation_csv(const std::vector<Recommendation>& all);

}  // namespace piae::report
