#pragma once

#include <filesystem>
#include <string>

#include "page/html.hpp"

namespace piae::page {

/// Style sheet and script of pages: two files that a user can change without a compiler.
struct Style {
  std::string css;
  std::string script;
};

/// Reads style.css and script.js of a folder. Throws Error(input_missing) if one cannot be read,
/// and Error(bad_input) if one contains the end tag of its own element.
Style read_style(const std::filesystem::path& folder);

/// Returns a whole page with style and script included. Its policy forbids the browser to contact
/// any server or to run any other script.
std::string document(const std::string& title, const Style& style, const Html& body);

}  // namespace piae::page
