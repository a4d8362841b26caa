#pragma once

#include <string>
#include <string_view>

namespace piae {

/// Whether a text has line breaks or other characters that are not printed but obeyed: by a
/// terminal (U+0000 to U+001F, U+007F to U+009F) or by whoever sets lines (U+2028, and the marks
/// that turn them round). What is no UTF-8 counts as such, since nobody knows what is made of it.
bool has_control_characters(std::string_view text);

/// The text with '?' in place of each of them, and "..." in place of what comes behind its first
/// thousand bytes: what a file holds must not break the one line of an error, make it endless, or
/// reach a terminal as a command.
std::string one_line(std::string_view text);

}  // namespace piae
