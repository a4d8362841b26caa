#pragma once

#include <string>
#include <vector>

#include "report/classifier_rows.hpp"
#include "report/document.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Whether a classifier knows when it does not know (scoring/confidence.hpp), with the windows of
/// one method at one ratio, over the seeds.
struct ConfidenceRow {
  scoring::Summary calibration_error;  ///< percent
  scoring::Summary answerable;         ///< percent of the test windows
  /// Whether it says of any seed's windows how sure it is.
  bool tells = false;
};

/// Of the cells of a row, of which `results` must have one.
ConfidenceRow confidence_of(const AccuracyRow& row, const run::Results& results);

/// confidence.csv: dataset,method,classifier,ratio,seeds,calibration_error_mean,
/// calibration_error_std,calibration_error_ci95_low,calibration_error_ci95_high,answerable_mean,
/// answerable_std,answerable_ci95_low,answerable_ci95_high,tells, in percent; `tells` is 1 where
/// the classifier says how sure it is. `results` are those that the rows were made from.
std::string confidence_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// How to read such a table, in sentences; `silent` are the names of the rows in which nothing is
/// said of how sure the classifier is.
std::string confidence_note(const std::vector<std::string>& silent);

/// One section with a method in each row, at its ratio with the most generated windows.
std::vector<Section> confidence_sections(const ClassifierRows& block, const run::Results& results);

}  // namespace piae::report
