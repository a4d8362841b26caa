#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace piae::page {

/// "1 cell", "2 cells". The plural of the word is made by an s.
std::string counted(std::size_t count, const std::string& word);

/// Ascending numbers with ranges: "0 to 4, 7".
std::string ranges_label(const std::vector<std::int64_t>& numbers);

}  // namespace piae::page
