#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.hpp"

namespace piae::run {

/// The part of the grid that a table shows, by the names that make and the folders use.
struct GridOptions {
  std::string dataset;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> seeds;
};

void bind(const cli::Options& command, GridOptions& options);
/// All but --dataset, for a program that knows it otherwise.
void bind_cells(const cli::Options& command, GridOptions& options);

/// One line of a table: its cells differ in nothing but the seed.
struct Combination {
  std::string method;
  std::string ratio;
};

struct Grid {
  std::string dataset;
  std::vector<std::string> scored;        ///< the methods that have scores, as asked for
  std::vector<Combination> combinations;  ///< methods as asked for, ratios as in Table 5
  std::vector<std::int64_t> seeds;        ///< ascending
};

/// The words of a list, which make may pass as one value or as many: "0 1 2", "0,1,2" and 0 1 2 are
/// the same. Throws Error(usage) with the option's name for an empty list and for a word named
/// twice.
std::vector<std::string> split_list(const std::string& option,
                                    const std::vector<std::string>& values);

/// Of the methods and ratios asked for, only these go together: `none` with 100to1, and every other
/// method with every other ratio. Lists may also come as one value with commas or spaces in it.
/// Throws Error(usage) for an empty list, a value named twice, an unknown ratio, a seed that is not
/// a number from 0 up, and methods and ratios of which none go together.
Grid resolve(const GridOptions& options);

}  // namespace piae::run
