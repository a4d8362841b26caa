#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::signal {

/// Has the program `read_raw`, which stands beside the one that runs, read a variable of a raw file
/// within the limits of raw_limits.hpp. A damaged file can make the libraries that read it crash,
/// or take all memory: then only that program ends. Throws read_raw's own Error, or
/// Error(bad_input) with the file and how the program has ended.
std::vector<double> read_elsewhere(const std::filesystem::path& file, const std::string& variable);

}  // namespace piae::signal
