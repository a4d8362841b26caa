#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace piae::raw {

/// Properties of a text file's column of times (times.hpp).
struct Times {
  std::uint64_t column = 0;            ///< counted from 1; 0 if there is none
  double unit_s = 0;                   ///< declared unit; 0 if there is none
  bool is_named = false;               ///< true if a name marks the column as times
  std::uint64_t samples = 0;           ///< count of numbers in the column
  double step = 0;                     ///< usual step in the unit of the file; 0: uneven
  bool is_uneven = false;              ///< true if the steps scatter more than rounding explains
  double mean_step = 0;                ///< mean of all steps that do not go back
  std::uint64_t gaps = 0;              ///< places where samples were dropped
  std::uint64_t missing = 0;           ///< samples missing in all gaps
  std::uint64_t longest = 0;           ///< samples missing in the longest gap
  std::uint64_t longest_after = 0;     ///< last sample before the longest gap, counted from 0
  std::uint64_t steps_back = 0;        ///< places where the times go back
  std::uint64_t first_back_after = 0;  ///< last sample before the first step back
};

/// Signal of one file.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< none if the file declares none
  std::size_t columns = 0;                              ///< of a text file; 0 for other formats
  Times times = {};                                     ///< of a text file
  /// True if a text ends in a number without a line end, shorter than nearly all others.
  bool may_be_cut = false;
};

/// Header of one file's samples among several files. read_raw writes its bytes before the samples.
struct Piece {
  std::uint64_t samples = 0;
  std::uint64_t columns = 0;  ///< of a text file; 0 for other formats
  Times times = {};
  std::uint64_t may_be_cut = 0;  ///< 1 if true
};

/// Signals of several files, concatenated.
struct Signals {
  std::vector<double> samples;
  std::vector<Piece> pieces;  ///< in the order of the files
};

}  // namespace piae::raw
