#pragma once

#include <cstddef>
#include <string>

namespace piae::page {

/// "1 cell", "2 cells". The plural of the word is made by an s.
std::string counted(std::size_t count, const std::string& word);

}  // namespace piae::page
