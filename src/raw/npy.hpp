#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::raw {

/// Reads a NumPy array, format 1.0 to 3.0 (numpy.lib.format): a vector as "1", a row or column of a
/// matrix as "(2,:)" or "(:,2)". Throws Error(bad_input) unless it holds real numbers.
std::vector<double> read_npy(const std::filesystem::path& file, const std::string& variable);

}  // namespace piae::raw
