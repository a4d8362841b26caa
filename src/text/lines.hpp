#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::text {

/// The lines of a file, without their ends. Throws Error(input_missing) where it cannot be read, or
/// is no file.
std::vector<std::string> read_lines(const std::filesystem::path& file);

}  // namespace piae::text
