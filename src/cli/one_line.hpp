#pragma once

#include <string>

namespace piae::cli {

/// Whether a text has line breaks or other characters that are not printed.
bool has_control_characters(const std::string& text);

/// The text with '?' in place of each of them: what a file holds must not break the one line of an
/// error, or reach a terminal as a command.
std::string one_line(std::string text);

}  // namespace piae::cli
