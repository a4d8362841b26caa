#include "report/largest_block.hpp"

#include <algorithm>

namespace piae::report {

Block largest_block(const std::vector<std::vector<std::size_t>>& has, std::size_t least_rows,
                    std::size_t least_columns) {
  Block best;
  for (const std::vector<std::size_t>& columns : has) {
    Block block{.columns = columns};
    for (std::size_t row = 0; row < has.size(); ++row) {
      if (std::ranges::includes(has[row], columns)) block.rows.push_back(row);
    }
    const bool counts = block.rows.size() >= least_rows && columns.size() >= least_columns;
    if (counts && block.rows.size() * columns.size() > best.rows.size() * best.columns.size()) {
      best = std::move(block);
    }
  }
  return best;
}

}  // namespace piae::report
