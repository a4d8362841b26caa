#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace piae::raw {

/// Returns the text of a raw file in UTF-8 without a byte order mark. Also reads UTF-16 with a
/// mark, in either byte order, which instruments and spreadsheets on Windows write. Throws
/// Error(bad_input) for UTF-16 without a mark, for control characters within the text, for binary
/// files and for files above largest_bytes; Error(input_missing) if the file is missing.
std::string read_text(const std::filesystem::path& file);

/// Converts text with a byte order mark to UTF-8 without the mark. Returns other bytes unchanged.
std::string without_byte_order_mark(std::string_view bytes);

}  // namespace piae::raw
