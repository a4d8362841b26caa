#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/recommendation.hpp"

namespace piae::report {

/// How the lines of such a table are to be read, in sentences.
inline constexpr const char* about_efforts =
    "Each line is the most accurate of those that take the same to be made or trained; a ceiling "
    "is not among them. Behind: points minus the best; p, of what takes less than the best: "
    "Wilcoxon's signed-rank test, two-sided and exact, with Holm's correction over these lines. "
    "Recommended is the line that takes least and is not significantly worse than the best; the "
    "best, where so few seeds cannot tell. Chosen and measured on the same test windows: expect a "
    "little less elsewhere.";

/// What is recommended with the most generated windows, why, and what of each class it recognises;
/// and what is recommended at each ratio, where there are several. None where there is nothing.
std::vector<Section> recommendation_sections(const std::vector<Recommendation>& all);

/// recommendation.csv: dataset,ratio,effort,method,classifier,seeds,mean,std,ci95_low,ci95_high,
/// behind,p_holm,missed_faults,false_alarms,best,recommended: a line for each effort at each ratio,
/// in percent and points; the last two are 0 or 1. Empty is what is not known or not asked.
std::string recommendation_csv(const std::vector<Recommendation>& all);

}  // namespace piae::report
