#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/accuracy_table.hpp"

namespace piae::report {

/// The rows that one classifier gave. Methods are compared within a classifier, never across.
struct ClassifierRows {
  std::string classifier;
  std::vector<AccuracyRow> rows;  ///< at least one
  /// What the bar (diagnosis/catalogue.hpp) reaches without any generated window; empty where that
  /// is not known, and for the rows of the bar itself.
  std::optional<AccuracyRow> bar = {};
};

/// The rows of each classifier that tables are made of, in the order of the catalogue. What the bar
/// reaches without generated windows has no tables of its own, unless there is nothing else: it
/// stands beside all others.
std::vector<ClassifierRows> by_classifier(const std::vector<AccuracyRow>& rows);

/// The rows of one classifier.
std::vector<AccuracyRow> rows_by(const std::vector<AccuracyRow>& rows,
                                 const std::string& classifier);

/// "none by nearest": how a table of another classifier names such a row.
std::string bar_label(const AccuracyRow& bar);

}  // namespace piae::report
