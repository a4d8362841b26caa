#pragma once

#include <cstddef>
#include <vector>

namespace piae::report {

/// Rows and columns of a table with gaps that have no gap among them.
struct Block {
  std::vector<std::size_t> rows = {};
  std::vector<std::size_t> columns = {};
};

/// The block with the most cells among those that are tried: of each row all columns that it has,
/// with every row that has them, too. In a table without gaps that is the whole table; a row with
/// few columns is left out before it makes the others lose theirs. `has` lists for each row the
/// columns that it has, ascending. Empty where no block has so many rows and columns.
Block largest_block(const std::vector<std::vector<std::size_t>>& has, std::size_t least_rows,
                    std::size_t least_columns);

}  // namespace piae::report
