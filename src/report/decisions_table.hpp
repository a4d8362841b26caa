#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/classifier_rows.hpp"
#include "report/document.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Decisions over some number of windows, by one classifier with the windows of one method at one
/// ratio, over the seeds that have them (scoring/decisions.hpp).
struct DecisionRow {
  std::size_t windows = 0;    ///< in a decision
  double decisions = 0;       ///< mean over the seeds
  scoring::Summary accuracy;  ///< percent
  scoring::Summary balanced;  ///< percent
};

/// Of the cells of a row, over this many windows; empty where no seed has such decisions.
std::optional<DecisionRow> decisions_over(std::size_t windows, const AccuracyRow& row,
                                          const run::Results& results);

/// Whether any cell has decisions: whether the run holds test windows.
bool has_decisions(const run::Results& results);

/// "Decisions over several windows are left out, since ..."; empty where the run has them.
std::string decisions_gap(const run::Results& results);

/// How to read a table of them, in sentences.
std::string decisions_note(const run::Results& results);

/// decisions.csv: dataset,method,classifier,ratio,windows,seeds,decisions,mean,std,ci95_low,
/// ci95_high,balanced_mean,balanced_std,balanced_ci95_low,balanced_ci95_high. The first four
/// numbers are the plain accuracy, in percent, the last four the balanced one; `windows` are those
/// of a decision, `decisions` the mean over the seeds of how many there are. What there is not has
/// no line. `results` are those that the rows were made from.
std::string decisions_csv(const std::vector<AccuracyRow>& rows, const run::Results& results);

/// One section: a method in each row, at its ratio with the most generated windows, and a number of
/// windows in each column; balanced accuracy. No section where there are no decisions.
std::vector<Section> decision_sections(const ClassifierRows& block, const run::Results& results);

}  // namespace piae::report
