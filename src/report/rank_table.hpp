#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "scoring/ranks.hpp"

namespace piae::report {

/// How the methods of a grid rank at one ratio: the best of a seed has rank 1.
struct RatioRanks {
  RatioColumn ratio;
  scoring::AverageRanks ranks;  ///< over the seeds, for each method of the RankTable
};

struct RankTable {
  std::string dataset;
  std::string classifier;
  /// All but ceilings, which are not ranked, and those left out.
  std::vector<std::string> methods;
  std::vector<std::string> left_out = {};  ///< for lack of cells that the others have
  bool has_every_seed = true;              ///< or else only those that all these methods have
  std::vector<RatioRanks> ratios = {};     ///< those at which all these methods have a row
  /// For each method the average rank over all these ratios and all seeds.
  std::vector<double> over_all_cells = {};
};

/// `rows` are of accuracy_rows() and of one classifier. `none` is ranked at every ratio, with its
/// one accuracy. Ranks are of methods that all have the same cells: those with the most cells
/// together (largest_block()). The table has no ratios where these are less than two
/// methods.
RankTable rank_methods(const std::vector<AccuracyRow>& rows);

/// The same for each classifier that has tables of its own.
std::vector<RankTable> rank_by_classifier(const std::vector<AccuracyRow>& rows);

/// ranks.csv: dataset,ratio,method,classifier,seeds,average_rank,friedman_p,critical_difference.
/// The ratio is "all" for all cells together, which have no test, since the cells of one seed are
/// no independent repeats.
std::string ranks_csv(const std::vector<RankTable>& tables);

/// One section with a method in each row and a ratio in each column. No section for a table without
/// ratios.
std::vector<Section> rank_sections(const RankTable& table);

}  // namespace piae::report
