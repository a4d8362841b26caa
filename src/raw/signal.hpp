#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace piae::raw {

/// One signal of a file.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< where the file says it
  std::size_t columns = 0;                              ///< of a text file; 0 for other formats
};

/// One file's part of the samples of several files. read_raw writes it in front of them, byte by
/// byte as it is.
struct Piece {
  std::uint64_t samples = 0;
  std::uint64_t columns = 0;  ///< of a text file; 0 for other formats
};

/// The signals of several files, one behind the other.
struct Signals {
  std::vector<double> samples;
  std::vector<Piece> pieces;  ///< in the order of the files
};

}  // namespace piae::raw
