#pragma once

#include <optional>
#include <vector>

namespace piae::raw {

/// What a file holds of one signal.
struct Signal {
  std::vector<double> samples;
  std::optional<double> sample_rate_hz = std::nullopt;  ///< where the file says it
};

}  // namespace piae::raw
