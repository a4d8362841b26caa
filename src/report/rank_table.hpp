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
  scoring::RankComparison comparison;  ///< over the seeds, in the order of the methods
};

struct RankTable {
  std::string dataset;
  std::vector<std::string> methods;    ///< all but ceilings, which compete with nobody
  std::vector<RatioRanks> ratios;      ///< at which all of them have a row
  std::vector<double> over_all_cells;  ///< average rank of each method over all ratios and seeds
};

/// `rows` are of accuracy_rows. `none` competes at every ratio. Empty where there are not two
/// methods to rank, or no ratio.
RankTable rank_methods(const std::vector<AccuracyRow>& rows);

/// ranks.csv: dataset,ratio,method,seeds,average_rank,friedman_p,critical_difference; the ratio is
/// "all" over all cells, which have no test: those of one seed are no independent repeats.
std::string ranks_csv(const RankTable& table);

/// One section with a method a row and a ratio a column; none for an empty table.
std::vector<Section> rank_sections(const RankTable& table);

}  // namespace piae::report
