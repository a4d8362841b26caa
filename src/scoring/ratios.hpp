#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace piae::scoring {

/// One column of the grid (paper, Table 5): how many windows are generated for the fault classes.
struct Ratio {
  const char* name;                  ///< "10to1": healthy to fault windows, as the paper names it
  std::int64_t generated_per_class;  ///< windows added to the known ones of each fault class
};

/// All seven, from 100to1 (nothing generated) to 1to1.
std::span<const Ratio> all_ratios();

/// For people: "100to1 (0), 50to1 (5), ...", with the generated windows in brackets.
std::string list_of_ratios();

/// Throws Error(usage) for a name that no ratio has; the line lists those there are.
const Ratio& find_ratio(const std::string& name);

/// How many healthy windows there really are for each window of one fault class: 500 / (5 + 145) =
/// 3.33 for the ratio that the paper names 2to1 (paper-notes, row 3). Nothing where there is no
/// window of a fault.
std::optional<double> true_ratio(std::int64_t normal_windows, std::int64_t known_per_class,
                                 std::int64_t generated_per_class);

}  // namespace piae::scoring
