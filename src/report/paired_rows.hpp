#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "scoring/paired.hpp"

namespace piae::report {

/// Accuracy of one row minus that of another, seed by seed, at one ratio or in the mean of ratios.
struct PairedRow {
  std::string method;
  std::string ratio;
  std::string ratio_label;            ///< for people: "2:1 (3.33:1)", "mean of 6"
  std::vector<std::int64_t> seeds;    ///< seeds that both have, ascending
  std::vector<double> differences;    ///< difference at each of these seeds, in points
  scoring::PairedDifference paired;   ///< of the differences
  std::optional<double> p_holm = {};  ///< p after Holm's correction, see add_holm_p()
  /// True if the seeds are enough for a corrected p of at most 0.05; see add_holm_p().
  bool p_can_be_small = true;
};

/// Returns `row` minus `other`, seed by seed, or nothing if they share no seed. Method and ratio
/// are those of `row`, except that `none` is compared at the ratio of `other`.
std::optional<PairedRow> paired_row(const AccuracyRow& row, const AccuracyRow& other);

/// Sets p_holm of all methods that have a p. Methods compared at the same ratio are one family of
/// tests; the means of the ratios are another. A ceiling (augment/catalogue.hpp) is not a method,
/// is in no family and gets no p_holm.
void add_holm_p(std::vector<PairedRow>& rows);

/// Returns the least corrected p that the seeds of a row can give. Holm's correction multiplies the
/// smallest p of a family by its size, and corrects no other p to less than the result.
double least_p_of(const PairedRow& row, const std::vector<PairedRow>& rows);

/// Returns the columns of CSV files:
/// seeds,mean_difference,ci95_low,ci95_high,rank_biserial,p,p_holm. All but the first two are empty
/// for a single seed, the interval for fewer than three (report/accuracies.hpp), and p_holm for a
/// ceiling.
Columns<PairedRow> paired_columns();

/// Returns the rows grouped by method, as pointers into `rows`.
std::vector<std::vector<const PairedRow*>> blocks_of(const std::vector<PairedRow>& rows);
/// Returns the name of a block's method, marked if the block has fewer seeds than other rows.
std::string block_label(const std::vector<const PairedRow*>& block,
                        const std::vector<PairedRow>& rows);

/// Returns a block for each method, with a row for each ratio: difference, interval, effect, p.
/// Marks a p that so few seeds cannot make small; paired_note() explains the mark. Expects at least
/// one row.
text::Table paired_table(const std::vector<PairedRow>& rows);

/// Note on the means of ratios in such a table.
inline constexpr const char* about_means_of_ratios =
    "The mean of ratios is taken for each seed, because ratios of one seed share their split and "
    "are not independent repeats.";

/// Returns the note below such a table: the meaning of its columns, `about_means`, and a warning if
/// the seeds are too few for a test.
std::string paired_note(const std::vector<PairedRow>& rows,
                        const std::string& about_means = about_means_of_ratios);

}  // namespace piae::report
