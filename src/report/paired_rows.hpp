#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "scoring/paired.hpp"

namespace piae::report {

/// The accuracies of a method minus others of the same seeds, at one ratio or in the mean of
/// ratios.
struct PairedRow {
  std::string method;
  std::string ratio;
  std::string ratio_label;            ///< for people: "2:1 (3.33:1)", "mean of 6"
  std::vector<std::int64_t> seeds;    ///< those that both have, ascending
  std::vector<double> differences;    ///< of each of these seeds, in points
  scoring::PairedDifference paired;   ///< of the differences
  std::optional<double> p_holm = {};  ///< p after Holm's correction, see add_holm_p()
  /// Whether so few seeds can give a corrected p below 0.05 at all, see add_holm_p().
  bool p_can_be_small = true;
};

/// `row` minus `other`, seed by seed. The result has the method of `row`, and its ratio unless that
/// is of `none`, which is compared at the ratio of the other. Empty where they have no seed in
/// common.
std::optional<PairedRow> paired_row(const AccuracyRow& row, const AccuracyRow& other);

/// Sets p_holm of all methods that have a p. Those that are compared at the same ratio are one
/// family of tests, and those that are compared in the mean of the ratios another. A ceiling
/// (augment/catalogue.hpp) is no method: it is in no family and has no p_holm.
void add_holm_p(std::vector<PairedRow>& rows);

/// The least p that so many seeds can give a row: Holm's correction multiplies the smallest of a
/// family by its size, and corrects no other to less than that one.
double least_p_of(const PairedRow& row, const std::vector<PairedRow>& rows);

/// The columns of CSV files: seeds,mean_difference,ci95_low,ci95_high,rank_biserial,p,p_holm. All
/// but the first two are empty for a single seed, the interval for fewer than three
/// (report/accuracies.hpp), and p_holm for a ceiling.
Columns<PairedRow> paired_columns();

/// The rows of each method together; they point into `rows`.
std::vector<std::vector<const PairedRow*>> blocks_of(const std::vector<PairedRow>& rows);
/// The name of a block's method, marked where it is of fewer seeds than other rows.
std::string block_label(const std::vector<const PairedRow*>& block,
                        const std::vector<PairedRow>& rows);

/// A block for each method, and in it a row for each ratio: difference, interval, effect, p. A p
/// that so few seeds cannot make small is marked; paired_note() says how. `rows` are at least one.
text::Table paired_table(const std::vector<PairedRow>& rows);

/// What is said of the means of ratios in such a table.
inline constexpr const char* about_means_of_ratios =
    "The mean of ratios is taken for each seed, since ratios of one seed share their split and are "
    "no independent repeats.";

/// The note below such a table: what its columns mean, what is said of the means in it, and a
/// warning where the seeds are too few to tell anything.
std::string paired_note(const std::vector<PairedRow>& rows,
                        const std::string& about_means = about_means_of_ratios);

}  // namespace piae::report
