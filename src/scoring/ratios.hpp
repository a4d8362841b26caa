#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace piae::scoring {

/// One column of the grid (paper, Table 5): the number of windows generated per fault class.
struct Ratio {
  const char* name;                  ///< "10to1": healthy to fault windows, named as in the paper
  std::int64_t generated_per_class;  ///< windows added to the known ones of each fault class
};

/// Returns all seven, from 100to1 (nothing generated) to 1to1.
std::span<const Ratio> all_ratios();

/// Returns text: "100to1 (0), 50to1 (5), ...", with the generated windows in brackets.
std::string list_of_ratios();

/// Throws Error(usage), which lists the known ratios, for an unknown name.
const Ratio& find_ratio(const std::string& name);

/// Returns the true number of healthy windows per window of one fault class: 500 / (5 + 145) = 3.33
/// for the ratio that the paper calls 2to1 (paper-notes, row 3). Empty without fault windows.
std::optional<double> true_ratio(std::int64_t normal_windows, std::int64_t known_per_class,
                                 std::int64_t generated_per_class);

}  // namespace piae::scoring
