#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/paper.hpp"
#include "run/collect.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// Between what a quantity lies, whatever is measured.
struct Bounds {
  double low;
  double high;
};

inline constexpr Bounds percents{0, 100};
/// Of two percents, in points.
inline constexpr Bounds differences_of_percents{-100, 100};

/// Leaves of the interval what can be shown to people.
///
/// It ends at the bounds. The true mean lies between them, so what is cut off never held it, and
/// the interval holds it as often as before. Of fewer than three values there is no interval: of
/// two, Student's t gives one of nine standard deviations to either side, which says nothing.
void bound(scoring::Summary& summary, const Bounds& bounds);

/// scoring::summarise() with such an interval.
scoring::Summary summarise_within(const Bounds& bounds, std::span<const double> values);

/// What tables for people say of these intervals.
inline constexpr const char* about_intervals =
    "95 % is the interval of the mean by Student's t, cut off where no mean can lie; there is none "
    "of fewer than three seeds, of which it would span nearly all that can be.";

/// One method at one ratio, by one classifier, over its seeds. The numbers are accuracies in
/// percent, or gains in points.
struct AccuracyRow {
  std::string dataset;
  std::string method;
  std::string classifier = scoring::paper_classifier;
  std::string ratio;
  std::int64_t generated_per_class = 0;
  std::optional<double> true_ratio;  ///< nothing where there was no fault window
  /// Of how many ratios the values are means; see report/ratio_means.hpp.
  std::size_t ratios = 1;
  std::vector<std::int64_t> seeds;  ///< ascending; not every row of a run has the same
  std::vector<double> values;       ///< by seed
  scoring::Summary summary;         ///< of the values, with the interval that can be shown
  /// The same of the accuracy by kind of defect, where it is told apart (run::Diagnosis).
  std::optional<scoring::Summary> kind;
  /// run::Diagnosis::speed_ratio: there where faults are known in other conditions than tested.
  std::optional<double> speed_ratio;
  /// What the paper publishes: of this dataset, or of its counterpart (report/paper.hpp),
  /// which is for orientation only. At most one of them is there, and none of another classifier.
  std::optional<double> published;
  std::optional<double> orientation;

  /// What the paper publishes, or its counterpart, to be shown next to the mean.
  [[nodiscard]] std::optional<double> theirs() const { return published ? published : orientation; }
  /// The value of a seed; empty where the row does not have it.
  [[nodiscard]] std::optional<double> at(std::int64_t seed) const;
};

/// The row of these cells, which differ in the seed alone and are at least one, without what the
/// paper publishes.
AccuracyRow accuracy_row(const std::string& dataset, const std::vector<run::Diagnosis>& cells);

/// A row for each combination of the grid of which `results` have a cell, in its order.
std::vector<AccuracyRow> accuracy_rows(const run::Grid& grid, const run::Results& results,
                                       const Published& published);

/// Each method that has a row, once, in the order of the rows.
std::vector<std::string> methods_of(const std::vector<AccuracyRow>& rows);
/// Whether the rows have accuracies by kind of defect; then all of them do, but no gains. What the
/// paper publishes is never of such a dataset.
bool tell_kinds(const std::vector<AccuracyRow>& rows);
/// The rows of one method.
std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method);

/// The seeds that any of the rows has, ascending.
std::vector<std::int64_t> seeds_of_any(const std::vector<AccuracyRow>& rows);

/// Values of two rows that have the seed in common.
struct Pairs {
  std::vector<std::int64_t> seeds;  ///< ascending
  std::vector<double> first;
  std::vector<double> second;
};
Pairs pairs_of(const AccuracyRow& first, const AccuracyRow& second);

/// What generated windows are worth, in points: for each row the accuracy minus that of `none` by
/// the same classifier, at the seeds that both have. The published gain is the difference of the
/// published accuracies. A row that has no seed in common with `none` is left out.
std::vector<AccuracyRow> gain_rows(const std::vector<AccuracyRow>& rows);

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

/// A row of accuracies, and how a table of its classifier names it.
struct ShownRow {
  std::string name;
  AccuracyRow row;
};

/// What a table has room for that shows each method once: of each its row with the most generated
/// windows, in the order of the rows; then the bar, where it is known.
std::vector<ShownRow> rows_with_most_windows(const ClassifierRows& block);

/// A column of a table in which methods are compared.
struct RatioColumn {
  std::string ratio;  ///< its name
  std::string label;  ///< for people
};

/// The ratios that any of the rows has, in the order of Table 5.
std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows);

/// The same without 100to1, at which only `none` has a row and nothing can be compared with it.
std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows);

/// The row of a method at a ratio, or null. For `none` it is its only row, whatever the ratio.
const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio);

}  // namespace piae::report
