#pragma once

#include <cstddef>
#include <string>

namespace piae::text {

/// Breaks a paragraph into lines of at most `widest` bytes between words, each with a line break. A
/// longer word gets a line of its own. Every line starts with `indent` spaces.
std::string wrap(const std::string& paragraph, std::size_t widest, std::size_t indent = 0);

}  // namespace piae::text
