#pragma once

#include <string>
#include <string_view>

namespace piae::cli {

/// Explains, for people who do not know TOML, what is wrong with a line and what to write instead:
/// a text without quotes, a decimal comma, a unit after a number, a backslash, curly quotes.
/// Returns an empty text for other mistakes.
std::string toml_advice(std::string_view line);

}  // namespace piae::cli
