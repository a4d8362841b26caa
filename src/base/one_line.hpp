#pragma once

#include <string>
#include <string_view>

namespace piae {

/// True if a text has line breaks or other characters that control a terminal (U+0000 to U+001F,
/// U+007F to U+009F) or the layout (U+2028, and marks that reverse the direction). Invalid UTF-8
/// counts, too, since its effect is unknown.
bool has_control_characters(std::string_view text);

/// Replaces each of these characters by '?', and everything after the first thousand bytes by
/// "...". Contents of a file must not break the single line of an error, make it endless, or send
/// commands to a terminal.
std::string one_line(std::string_view text);

}  // namespace piae
