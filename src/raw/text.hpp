#pragma once

#include <filesystem>
#include <string>

namespace piae::raw {

/// The text of a raw file in UTF-8, without a byte order mark. With one, UTF-16 of either byte
/// order is read, too, as instruments and spreadsheets on Windows write it. Throws Error(bad_input)
/// for UTF-16 without a mark, and where the file is larger than any that is read;
/// Error(input_missing) where there is none.
std::string read_text(const std::filesystem::path& file);

}  // namespace piae::raw
