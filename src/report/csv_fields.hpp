#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scoring/statistics.hpp"

namespace piae::report {

// Fields of the CSV files that tables are written to.

/// A number with four decimals, or an empty field where there is none.
std::string four_decimals(std::optional<double> number);

/// Mean and standard deviation. The latter is empty for a single repeat.
std::vector<std::string> mean_fields(const scoring::Summary& summary);

/// The ends of the 95 % interval, both empty for a single repeat.
std::vector<std::string> interval_fields(const scoring::Summary& summary);

/// A line of several groups of fields.
std::string joined_csv_line(const std::vector<std::vector<std::string>>& groups);

}  // namespace piae::report
