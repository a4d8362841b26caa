#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "cli/options.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

/// Part of the grid that a table shows, by the names that make and the folders use. A list may be
/// one value with several words, see split_list().
struct GridOptions {
  std::string dataset = {};
  std::vector<std::string> methods = {};
  std::vector<std::string> ratios = {};
  std::vector<std::string> seeds = {};
  std::vector<std::string> classifiers = {};  ///< default: the paper's, without the baseline's
  /// Data sets without known fault windows. Names of other data sets are ignored.
  std::vector<std::string> nothing_known = {};
};

void bind(const cli::Options& command, GridOptions& options);
/// Binds all options except --dataset, for a program that has the dataset from elsewhere.
void bind_cells(const cli::Options& command, GridOptions& options);
/// Binds --nothing-known, which make passes for the data sets whose known-per-class is 0.
void bind_nothing_known(const cli::Options& command, std::vector<std::string>& nothing_known);
/// Binds --classifiers. `otherwise` describes the default in the help.
void bind_classifiers(const cli::Options& command, std::vector<std::string>& classifiers,
                      const std::string& otherwise);

/// A method, a ratio and a classifier. Cells of one combination differ only in the seed.
struct Combination {
  std::string method;
  std::string ratio;
  std::string classifier = scoring::paper_classifier;

  bool operator==(const Combination&) const = default;
};

/// Names a method in texts: "vae", or "vae by nearest" if the classifier is not the paper's. Marks
/// classifiers that adapt (diagnosis::marked_name()).
std::string name_by(const std::string& method, const std::string& classifier);

/// The cells of one data set.
struct Grid {
  std::string dataset;
  std::vector<std::string> scored;  ///< methods with scores, in the requested order
  /// Classifiers and methods in the requested order, ratios as in Table 5.
  std::vector<Combination> combinations;
  std::vector<std::int64_t> seeds;  ///< ascending
};

/// Splits a list into words. make passes a list as one value, people pass several: "0 1 2", "0,1,2"
/// and 0 1 2 are the same. Throws Error(usage) with the option's name for an empty list or a
/// repeated word.
std::vector<std::string> split_list(const std::string& option,
                                    const std::vector<std::string>& values);

/// True if a method has cells at a ratio: `none` only at 100to1, every other method only at the
/// other ratios.
bool go_together(const std::string& method, const scoring::Ratio& ratio);

/// True if a method has cells by a classifier, in a data set with or without known fault windows.
/// This rule is defined only here.
///
/// A rule (diagnosis/catalogue.hpp) has cells with `none` only. Without known faults, `none` has no
/// training windows for other classifiers, so only methods that work without known windows have
/// cells.
bool go_together(const augment::CatalogueEntry& method, const diagnosis::Classifier& classifier,
                 bool nothing_known);
/// Takes names. A method that is not in the catalogue counts as one that needs known windows.
bool go_together(const std::string& method, const std::string& classifier, bool nothing_known);

/// True if a method has scores: all except `none`, which has no windows, and ceilings.
bool has_score(const std::string& method);

/// Returns the grid with the cells of one classifier only.
Grid of_classifier(Grid grid, const std::string& classifier);

/// Returns the requested cells that are possible. If classifiers are named and `none` is among the
/// methods, adds the cell of `none` by the baseline's classifier (diagnosis/catalogue.hpp), unless
/// nothing is known. Throws Error(usage) for an empty list, a repeated value, an unknown ratio or
/// classifier, a seed that is not a number from 0 up, and if no cell is possible.
Grid resolve(const GridOptions& options);

}  // namespace piae::run
