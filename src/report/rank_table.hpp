#pragma once

#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/ratio_columns.hpp"
#include "scoring/ranks.hpp"

namespace piae::report {

/// How the methods of a grid rank at one ratio: the best of a seed has rank 1.
struct RatioRanks {
  RatioColumn ratio;
  scoring::AverageRanks ranks;  ///< over the seeds, for each method of the RankTable
};

struct RankTable {
  std::string dataset;
  std::vector<std::string> methods;     ///< all but ceilings, which are not ranked
  std::vector<RatioRanks> ratios = {};  ///< those at which all methods have a row
  /// For each method the average rank over all these ratios and all seeds.
  std::vector<double> over_all_cells = {};
};

/// `rows` are of accuracy_rows(). `none` is ranked at every ratio, with its one accuracy. The table
/// has no ratios where there are less than two methods, or no ratio at which all have a row.
RankTable rank_methods(const std::vector<AccuracyRow>& rows);

/// ranks.csv: dataset,ratio,method,seeds,average_rank,friedman_p,critical_difference. The ratio is
/// "all" for all cells together, which have no test, since the cells of one seed are no independent
/// repeats.
std::string ranks_csv(const RankTable& table);

/// One section with a method in each row and a ratio in each column. No section for a table without
/// ratios.
std::vector<Section> rank_sections(const RankTable& table);

}  // namespace piae::report
