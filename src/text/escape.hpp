#pragma once

#include <string>

namespace piae::text {

/// Plain text as it must stand in Markdown, a table's cell included, to be read as it is.
std::string markdown_text(const std::string& text);

/// Plain text as it must stand in LaTeX, outside of mathematics, to be read as it is; the sign of a
/// number becomes one of mathematics. Of letters beyond ASCII, ± and ² become commands, and all
/// others are kept: LaTeX reads UTF-8.
std::string latex_text(const std::string& text);

}  // namespace piae::text
