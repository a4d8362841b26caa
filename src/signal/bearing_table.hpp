#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace piae::signal {

/// Returns the keys of [bearing] that a table of bearings (pipeline/bearings.csv) has for a
/// designation: the geometry, or the orders if the row has no geometry. Ignores case, blanks and
/// hyphens. Some words of a designation are enough: "6205-2RS" finds "SKF 6205-2RS JEM". Returns
/// the first of several matching rows.
/// Throws Error(input_missing) without the table. Throws Error(bad_input) if no row matches, if
/// matching rows differ by more than 1 % in BPFO or BPFI, or if the table is damaged.
std::map<std::string, double> bearing_called(const std::string& designation,
                                             const std::filesystem::path& table);

}  // namespace piae::signal
