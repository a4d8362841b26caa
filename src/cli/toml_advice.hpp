#pragma once

#include <string>
#include <string_view>

namespace piae::cli {

/// What is wrong with a line that is no TOML, in the words of somebody who has never seen TOML, and
/// what to write instead: a word or a text without quotes, a decimal comma, a unit behind a number,
/// a backslash, curly quotes. Empty where it is none of these usual slips.
std::string toml_advice(std::string_view line);

}  // namespace piae::cli
