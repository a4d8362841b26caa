#pragma once

#include <filesystem>

#include "text/html_page.hpp"

namespace piae::page {

using text::document;
using text::Style;

/// Reads style.css and script.js of a folder, two files that a user can change without a compiler.
/// Throws Error(input_missing) if one cannot be read, and Error(bad_input) if one contains the end
/// tag of its own element.
Style read_style(const std::filesystem::path& folder);

}  // namespace piae::page
