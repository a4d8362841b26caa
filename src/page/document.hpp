#pragma once

#include <filesystem>
#include <string>

#include "page/html.hpp"

namespace piae::page {

/// How pages look and what they do: two files that a user can change without a compiler.
struct Style {
  std::string css;
  std::string script;
};

/// Reads style.css and script.js of a folder. Throws Error(input_missing) where one cannot be read,
/// and Error(bad_input) for one that would end its own element.
Style read_style(const std::filesystem::path& folder);

/// A whole page: style and script are in it, and a policy that forbids the browser to ask any
/// server for anything or to run any other script.
std::string document(const std::string& title, const Style& style, const Html& body);

}  // namespace piae::page
