#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>

namespace piae {

/// Counts a word in a text.
inline std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

/// Returns the number of characters of a line: bytes that start a UTF-8 character.
inline std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(
      std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Expects that all x of points, texts and rectangles lie on a picture (SVG) of this width, and
/// that there are many.
inline void expect_on_paper(const std::string& svg, double width, std::size_t at_least) {
  const std::regex place("(points=\"|[0-9] |x=\"|width=\")(-?[0-9.]+)[,\"]");
  std::size_t places = 0;
  for (auto at = std::sregex_iterator(svg.begin(), svg.end(), place); at != std::sregex_iterator();
       ++at, ++places) {
    EXPECT_GE(std::stod((*at)[2]), 0) << at->str();
    EXPECT_LE(std::stod((*at)[2]), width) << at->str();
  }
  EXPECT_GE(places, at_least);
}

}  // namespace piae
