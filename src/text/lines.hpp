#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::text {

/// Returns the lines of a file without line ends. Throws Error(input_missing) if it is not a
/// regular file or cannot be read.
std::vector<std::string> read_lines(const std::filesystem::path& file);

}  // namespace piae::text
