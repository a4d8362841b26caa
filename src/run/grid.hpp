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

/// Which part of the grid a table shows, by the names that make and the folders use. A list may
/// come as one value with several words in it, see split_list().
struct GridOptions {
  std::string dataset = {};
  std::vector<std::string> methods = {};
  std::vector<std::string> ratios = {};
  std::vector<std::string> seeds = {};
  std::vector<std::string> classifiers = {};  ///< the paper's where none is given, and no bar
  /// Data sets of which no fault window is known; others may be named, too.
  std::vector<std::string> nothing_known = {};
};

void bind(const cli::Options& command, GridOptions& options);
/// Binds all but --dataset, for a program that knows the dataset from elsewhere.
void bind_cells(const cli::Options& command, GridOptions& options);
/// Binds --nothing-known, which make passes for the data sets whose known-per-class is 0.
void bind_nothing_known(const cli::Options& command, std::vector<std::string>& nothing_known);
/// Binds --classifiers, of which the help says what is meant where it is not given.
void bind_classifiers(const cli::Options& command, std::vector<std::string>& classifiers,
                      const std::string& otherwise);

/// A method, a ratio and a classifier. The cells of one combination differ in nothing but the seed.
struct Combination {
  std::string method;
  std::string ratio;
  std::string classifier = scoring::paper_classifier;

  bool operator==(const Combination&) const = default;
};

/// How texts name a method: "vae", or "vae by nearest" where the classifier is not the paper's.
std::string name_by(const std::string& method, const std::string& classifier);

/// The cells of one dataset.
struct Grid {
  std::string dataset;
  std::vector<std::string> scored;  ///< the methods that have scores, in the order asked for
  /// Classifiers and methods in the order asked for, ratios as in Table 5.
  std::vector<Combination> combinations;
  std::vector<std::int64_t> seeds;  ///< ascending
};

/// The words of a list. make passes a list as one value, people pass several: "0 1 2", "0,1,2" and
/// 0 1 2 are the same. Throws Error(usage) with the option's name for an empty list and for a word
/// that is there twice.
std::vector<std::string> split_list(const std::string& option,
                                    const std::vector<std::string>& values);

/// Whether a method has cells at a ratio: `none`, which generates nothing, at 100to1 only, and
/// every other method at every other ratio only.
bool go_together(const std::string& method, const scoring::Ratio& ratio);

/// Whether a method has cells by a classifier, in a data set of which fault windows are known or
/// not. This is the one place that knows it; make asks for it by the program `settings`.
///
/// A rule (diagnosis/catalogue.hpp) is run with `none` alone. Where nothing is known, `none` has
/// nothing to show to other classifiers, and only methods that need no known window make any.
bool go_together(const augment::CatalogueEntry& method, const diagnosis::Classifier& classifier,
                 bool nothing_known);
/// The same by their names. A method that the catalogue does not have needs known windows.
bool go_together(const std::string& method, const std::string& classifier, bool nothing_known);

/// Whether a method has scores: not `none`, which has no windows, and no ceiling.
bool has_score(const std::string& method);

/// The same grid with the cells of one classifier alone.
Grid of_classifier(Grid grid, const std::string& classifier);

/// The cells asked for, as far as there can be such. Where classifiers are named and `none` is
/// among the methods, it has a cell of the bar (diagnosis/catalogue.hpp) whatever they are, unless
/// nothing is known. Throws Error(usage) for an empty list, a value that is there twice, an unknown
/// ratio or classifier, a seed that is not a number from 0 up, and methods, ratios and classifiers
/// of which none go together.
Grid resolve(const GridOptions& options);

}  // namespace piae::run
