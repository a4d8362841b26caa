#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"

namespace piae::report {

// Decisions over several windows of a record (scoring/decisions.hpp), and whether a classifier
// knows when it does not know (scoring/confidence.hpp). `results` are those that the rows were made
// from.

/// decisions.csv: dataset,method,classifier,ratio,windows,seeds,decisions,mean,std,ci95_low,
/// ci95_high,balanced_mean,balanced_std,balanced_ci95_low,balanced_ci95_high. The first four
/// numbers are the plain accuracy, in percent, the last four the balanced one; `windows` are those
/// of a decision, `decisions` the mean over the seeds of how many there are. What there is not has
/// no line.
std::string decisions_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// One section: a method in each row, at its ratio with the most generated windows, and a number of
/// windows in each column; balanced accuracy. No section where there are no decisions.
std::vector<Section> decision_sections(const ClassifierRows& block, const run::Results& results);

/// "Decisions over several windows are left out, since ..."; empty where the run has them.
std::string decisions_gap(const run::Results& results);

/// confidence.csv: dataset,method,classifier,ratio,seeds,calibration_error_mean,
/// calibration_error_std,calibration_error_ci95_low,calibration_error_ci95_high,answerable_mean,
/// answerable_std,answerable_ci95_low,answerable_ci95_high,tells, in percent; `tells` is 1 where
/// the classifier says how sure it is.
std::string confidence_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// One section with a method in each row, at its ratio with the most generated windows.
std::vector<Section> confidence_sections(const ClassifierRows& block, const run::Results& results);

}  // namespace piae::report
