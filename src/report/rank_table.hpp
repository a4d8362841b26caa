#pragma once

#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "scoring/ranks.hpp"

namespace piae::report {

/// Ranks of the methods of a grid at one ratio. The best method of a seed has rank 1.
struct RatioRanks {
  RatioColumn ratio;
  scoring::AverageRanks ranks;  ///< over the seeds, for each method of the RankTable
};

struct RankTable {
  std::string dataset;
  std::string classifier;
  /// Ranked methods: all but ceilings and `left_out`.
  std::vector<std::string> methods;
  std::vector<std::string> left_out = {};  ///< methods that lack cells which the others have
  bool has_every_seed = true;  ///< false if seeds that some of these methods lack were left out
  std::vector<RatioRanks> ratios = {};  ///< ratios at which all these methods have a row
  /// For each method the average rank over all these ratios and seeds.
  std::vector<double> over_all_cells = {};
};

/// Ranks the methods that have the most cells in common (largest_block()). `rows` are
/// accuracy_rows() of one classifier. `none` is ranked at every ratio with its one accuracy. The
/// table has no ratios if fewer than two methods have common cells.
RankTable rank_methods(const std::vector<AccuracyRow>& rows);

/// The same for each classifier that has tables of its own.
std::vector<RankTable> rank_by_classifier(const std::vector<AccuracyRow>& rows);

/// Returns ranks.csv:
/// dataset,ratio,method,classifier,seeds,average_rank,friedman_p,critical_difference. The ratio is
/// "all" for all cells together, which have no test because the cells of one seed are not
/// independent repeats.
std::string ranks_csv(const std::vector<RankTable>& tables);

/// Returns a section with a method in each row and a ratio in each column, or no section for a
/// table without ratios.
std::vector<Section> rank_sections(const RankTable& table);

}  // namespace piae::report
