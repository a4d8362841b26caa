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

/// Limits of a quantity, whatever is measured.
struct Bounds {
  double low;
  double high;
};

inline constexpr Bounds percents{0, 100};
/// Limits of the difference of two percentages, in points.
inline constexpr Bounds differences_of_percents{-100, 100};

/// Reduces the interval of `summary` to what can be shown to people.
///
/// Cuts the interval off at `bounds`. The true mean lies within them, so its coverage stays the
/// same. Removes the interval of fewer than three values: for two, Student's t gives nine standard
/// deviations to either side.
void bound(scoring::Summary& summary, const Bounds& bounds);

/// scoring::summarise() with an interval as bound() leaves it.
scoring::Summary summarise_within(const Bounds& bounds, std::span<const double> values);

/// Note on these intervals in tables for people.
inline constexpr const char* about_intervals =
    "95 % is the interval of the mean by Student's t, cut off at values that no mean can have; it "
    "is not given for fewer than three seeds, because it would span almost all values.";

/// One method at one ratio, by one classifier, over its seeds. Values are accuracies in percent, or
/// gains in points.
struct AccuracyRow {
  std::string dataset;
  std::string method;
  std::string classifier = scoring::paper_classifier;
  std::string ratio;
  std::int64_t generated_per_class = 0;
  std::optional<double> true_ratio;  ///< empty without fault windows
  /// Number of ratios that the values are means of; see report/ratio_means.hpp.
  std::size_t ratios = 1;
  std::vector<std::int64_t> seeds;  ///< ascending; rows of a run may have different seeds
  std::vector<double> values;       ///< by seed
  scoring::Summary summary;         ///< of the values, with the interval that can be shown
  /// The same for the accuracy by fault type, for data sets that have it (run::Diagnosis).
  std::optional<scoring::Summary> type_accuracy;
  /// run::Diagnosis::speed_ratio; set if faults are known in other conditions than tested.
  std::optional<double> speed_ratio;
  /// Published number of this dataset, or of its counterpart (report/paper.hpp), which is for
  /// orientation only. At most one of them is set, and only for the paper's classifier.
  std::optional<double> published;
  std::optional<double> orientation;

  /// Returns the number of the paper or of its counterpart, to be shown next to the mean.
  [[nodiscard]] std::optional<double> theirs() const { return published ? published : orientation; }
  /// Returns the value of a seed, or nothing if the row does not have the seed.
  [[nodiscard]] std::optional<double> at(std::int64_t seed) const;
};

/// Returns the row of these cells, without published numbers. Expects at least one cell; the cells
/// differ in the seed only.
AccuracyRow accuracy_row(const std::string& dataset, const std::vector<run::Diagnosis>& cells);

/// Returns a row for each combination of the grid that has a cell in `results`, in the grid's
/// order.
std::vector<AccuracyRow> accuracy_rows(const run::Grid& grid, const run::Results& results,
                                       const Published& published);

/// Returns each method that has a row, once, in the order of the rows.
std::vector<std::string> methods_of(const std::vector<AccuracyRow>& rows);
/// True if the rows have accuracies by fault type. Then all rows have them, but gains do not. The
/// paper has no numbers for such data sets.
bool have_fault_types(const std::vector<AccuracyRow>& rows);
/// Returns the rows of one method.
std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method);

/// Returns the seeds that any of the rows has, ascending.
std::vector<std::int64_t> seeds_of_any(const std::vector<AccuracyRow>& rows);

/// Values of two rows at the seeds that both have.
struct Pairs {
  std::vector<std::int64_t> seeds;  ///< ascending
  std::vector<double> first;
  std::vector<double> second;
};
Pairs pairs_of(const AccuracyRow& first, const AccuracyRow& second);

/// Returns the gain by generated windows, in points: the accuracy of each row minus that of `none`
/// by the same classifier, at the seeds that both have. The published gain is the difference of the
/// published accuracies. Leaves out rows that share no seed with `none`.
std::vector<AccuracyRow> gain_rows(const std::vector<AccuracyRow>& rows);

/// Rows of one classifier. Methods are compared within a classifier, never across.
struct ClassifierRows {
  std::string classifier;
  std::vector<AccuracyRow> rows;  ///< at least one
  /// Reference: accuracy of the reference classifier (diagnosis/catalogue.hpp) without generated
  /// windows. Empty if unknown, and for the rows of the reference classifier itself.
  std::optional<AccuracyRow> reference_row = {};
};

/// Returns the rows of each classifier that gets tables, in the order of the catalogue. The
/// reference classifier without generated windows gets no tables of its own, because its row is in
/// all the others; it gets them only if there is nothing else.
std::vector<ClassifierRows> by_classifier(const std::vector<AccuracyRow>& rows);

/// Returns the rows of one classifier.
std::vector<AccuracyRow> rows_by(const std::vector<AccuracyRow>& rows,
                                 const std::string& classifier);

/// Returns "none by nearest", the name of such a row in the table of another classifier.
std::string reference_label(const AccuracyRow& reference_row);

/// A row of accuracies and its name in a table of its classifier.
struct ShownRow {
  std::string name;
  AccuracyRow row;
};

/// Returns one row for each method, for tables without room for more: the row with the most
/// generated windows, in the order of the rows. The reference follows if it is known.
std::vector<ShownRow> rows_with_most_windows(const ClassifierRows& block);

/// A column of a table in which methods are compared.
struct RatioColumn {
  std::string ratio;  ///< its name
  std::string label;  ///< for people
};

/// Returns the ratios that any of the rows has, in the order of Table 5.
std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows);

/// The same without 100to1, at which only `none` has a row.
std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows);

/// Returns the row of a method at a ratio, or null. `none` has one row, which is returned for every
/// ratio.
const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio);

}  // namespace piae::report
