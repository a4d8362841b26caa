#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace piae::signal {

/// Gives the keys of [bearing], with their values, that a table of bearings (pipeline/bearings.csv)
/// has for a designation: a geometry where the row has one, else orders. Case, blanks and hyphens
/// do not matter, and some words of a row's designation will do, "6205-2RS" for "SKF 6205-2RS JEM";
/// among several such rows the first is taken.
/// Throws Error(input_missing) without the table, and Error(bad_input) where no row has the
/// designation, rows that have it differ by more than 1 % in BPFO or BPFI, or the row is damaged.
std::map<std::string, double> bearing_called(const std::string& designation,
                                             const std::filesystem::path& table);

}  // namespace piae::signal
