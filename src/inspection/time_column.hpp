#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace piae::inspection {

/// Places where a column of times jumps, since samples between were dropped.
struct Dropouts {
  std::size_t gaps = 0;
  std::size_t missing = 0;        ///< samples, in all of them
  std::size_t longest = 0;        ///< samples that the longest one misses
  std::size_t longest_after = 0;  ///< the last sample before it, counted from 0
};

/// Finds steps of more than 1.5 times the median step. Nothing where the times do not rise, or
/// where less than nine tenths of the steps are within a quarter of the median: they are then
/// printed too coarsely to tell.
Dropouts dropouts_in(std::span<const double> times);

/// Finds the same in the first column of the text files of a record, if another one is the
/// signal's; what lies between two files is not looked at. Nothing where the first file is not
/// text, or a first column does not hold numbers.
Dropouts dropouts_of(const std::vector<std::filesystem::path>& files, const std::string& variable);

}  // namespace piae::inspection
