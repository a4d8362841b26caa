#pragma once

#include <string>

#include "text/html.hpp"

namespace piae::text {

/// Style sheet and script of a page.
struct Style {
  std::string css;
  std::string script;
};

/// Returns a whole page with style and script included. Its policy forbids the browser to contact
/// any server or to run any other script.
std::string document(const std::string& title, const Style& style, const Html& body);

}  // namespace piae::text
