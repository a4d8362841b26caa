#pragma once

#include <string>

namespace piae::text {

/// Escapes plain text so that Markdown shows it as it is, also in the cell of a table.
std::string markdown_text(const std::string& text);

/// Escapes plain text so that LaTeX shows it as it is, outside of mathematics. The sign of a number
/// is set as mathematics, so that a minus is no hyphen. Signs that tables use (± ² – † ‡)
/// become commands; other characters beyond ASCII are kept, since LaTeX reads UTF-8.
std::string latex_text(const std::string& text);

}  // namespace piae::text
