#pragma once

#include <optional>
#include <vector>

namespace piae::raw {

/// One signal of a file.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< where the file says it
};

}  // namespace piae::raw
