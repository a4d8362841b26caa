#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace piae::raw {

/// One signal of a file.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< where the file says it
  std::size_t columns = 0;                              ///< of a text file; 0 for other formats
};

}  // namespace piae::raw
