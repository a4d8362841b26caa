#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace piae::raw {

/// What a column of times next to the samples of a text tells of them (times.hpp).
struct Times {
  std::uint64_t column = 0;            ///< counted from 1; 0 where there is none
  double unit_s = 0;                   ///< where a name says it; else 0
  bool is_named = false;               ///< a name says that the column holds times
  std::uint64_t samples = 0;           ///< numbers in the column
  double step = 0;                     ///< the usual one, in the unit of the file; 0: uneven
  bool is_uneven = false;              ///< the steps scatter more than rounding does
  double mean_step = 0;                ///< of all that do not go back
  std::uint64_t gaps = 0;              ///< places where samples were dropped
  std::uint64_t missing = 0;           ///< samples, in all of them
  std::uint64_t longest = 0;           ///< samples that the longest one misses
  std::uint64_t longest_after = 0;     ///< the last sample before it, counted from 0
  std::uint64_t steps_back = 0;        ///< places where the times go back
  std::uint64_t first_back_after = 0;  ///< the last sample before the first of these
};

/// One signal of a file.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< where the file says it
  std::size_t columns = 0;                              ///< of a text file; 0 for other formats
  Times times = {};                                     ///< of a text file
};

/// One file's part of the samples of several files. read_raw writes it in front of them, byte by
/// byte as it is.
struct Piece {
  std::uint64_t samples = 0;
  std::uint64_t columns = 0;  ///< of a text file; 0 for other formats
  Times times = {};
};

/// The signals of several files, one behind the other.
struct Signals {
  std::vector<double> samples;
  std::vector<Piece> pieces;  ///< in the order of the files
};

}  // namespace piae::raw
