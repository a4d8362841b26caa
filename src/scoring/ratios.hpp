#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace piae::scoring {

/// One column of the grid (paper, Table 5): how far the fault classes are filled up.
struct Ratio {
  const char* name;                  ///< "10to1": as the paper names it, normal to fault windows
  std::int64_t generated_per_class;  ///< windows added to the known ones of each fault class
};

/// All seven, from 100to1 (nothing generated) to 1to1.
std::span<const Ratio> all_ratios();

/// Throws Error(usage) that lists those there are.
const Ratio& find_ratio(const std::string& name);

/// Normal windows to windows of one fault class as they are: 500 / (5 + 145) = 3.33 for "2to1"
/// (paper-notes, row 3).
double true_ratio(std::int64_t normal_windows, std::int64_t known_per_class,
                  std::int64_t generated_per_class);

}  // namespace piae::scoring
