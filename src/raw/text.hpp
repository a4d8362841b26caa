#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace piae::raw {

/// Returns the text of a raw file in UTF-8 without a byte order mark. Also reads UTF-16 with a
/// mark, in either byte order, which instruments and spreadsheets on Windows write. Throws
/// Error(bad_input) for UTF-16 without a mark, for control characters in lines that may be rows,
/// for binary files and for files above largest_bytes; Error(input_missing) if the file is missing.
std::string read_text(const std::filesystem::path& file);

/// Refuses control characters from `begin` on, where the table begins. A crash may leave nulls in
/// the middle of a file, where two halves of different lines would become one.
void require_no_control_characters(const std::filesystem::path& file, std::string_view text,
                                   std::size_t begin);

/// Returns the text with blanks for control characters, which may pad the fields of a header.
/// Returns empty text if there are none, because copying would double the memory.
std::string with_blanks_for_control(std::string_view text);

/// Converts text with a byte order mark to UTF-8 without the mark. Returns other bytes unchanged.
std::string without_byte_order_mark(std::string_view bytes);

}  // namespace piae::raw
