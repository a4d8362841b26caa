#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace piae::report {

/// The method that generates nothing. It has the ratio 100to1 to itself.
inline const std::string no_method = "none";

/// The part of the grid that a table shows, by the names that make and the folders use.
struct GridOptions {
  std::string dataset;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> seeds;
};

void bind(CLI::App& app, GridOptions& options);

/// One line of a table: its cells differ in nothing but the seed.
struct Combination {
  std::string method;
  std::string ratio;
};

struct Grid {
  std::string dataset;
  std::vector<std::string> generators;    ///< the methods that generate windows, as asked for
  std::vector<Combination> combinations;  ///< methods as asked for, ratios as in Table 5
  std::vector<std::int64_t> seeds;        ///< ascending
};

/// Of the methods and ratios asked for, only these go together: `none` with 100to1, and every other
/// method with every other ratio. Lists may also come as one value with commas or spaces in it.
/// Throws Error(usage) for an empty list, a value named twice, an unknown ratio, a seed that is not
/// a number from 0 up, and methods and ratios of which none go together.
Grid resolve(const GridOptions& options);

}  // namespace piae::report
