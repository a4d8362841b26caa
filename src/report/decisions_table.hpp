#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

// Decisions over several windows of a record (scoring/decisions.hpp), and confidence of a
// classifier (scoring/confidence.hpp). `results` are the cells that the rows were made from.

/// Returns decisions.csv:
/// dataset,method,classifier,ratio,windows,seeds,decisions,mean,std,ci95_low,
/// ci95_high,balanced_mean,balanced_std,balanced_ci95_low,balanced_ci95_high. mean to ci95_high are
/// the plain accuracy, the others the balanced accuracy, both in percent. `windows` is per
/// decision, `decisions` the mean over the seeds. Rows without decisions are left out.
std::string decisions_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// Returns a section of balanced accuracies, with a number of windows in each column. Each row is a
/// method at its ratio with the most generated windows. Returns no section without decisions.
std::vector<Section> decision_sections(const ClassifierRows& block, const run::Results& results);

/// Returns why decisions over several windows are left out; "" if the run has them.
std::string decisions_gap(const run::Results& results);

/// Returns confidence.csv: dataset,method,classifier,ratio,seeds,calibration_error_mean,
/// calibration_error_std,calibration_error_ci95_low,calibration_error_ci95_high,answerable_mean,
/// answerable_std,answerable_ci95_low,answerable_ci95_high,tells, in percent. `ranks_answers` is 1
/// if the classifier reports its confidence.
std::string confidence_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// Returns a section with a method in each row, at its ratio with the most generated windows.
std::vector<Section> confidence_sections(const ClassifierRows& block, const run::Results& results);

}  // namespace piae::report
