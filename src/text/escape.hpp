#pragma once

#include <string>

namespace piae::text {

/// Escapes plain text for Markdown, also in the cells of a table.
std::string markdown_text(const std::string& text);

/// Escapes plain text for HTML and XML, also for attribute values in double quotes.
std::string markup_text(const std::string& text);

/// Escapes plain text for LaTeX outside of mathematics. The sign of a number is set as mathematics,
/// so that a minus does not look like a hyphen. Signs that tables use (± ² – † ‡) become commands.
/// Other characters beyond ASCII are kept, since LaTeX reads UTF-8.
std::string latex_text(const std::string& text);

}  // namespace piae::text
