#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Windows as a classifier sees them.
struct LabelledWindows {
  std::size_t length = 0;            ///< samples in a window
  std::size_t classes = 0;           ///< labels are in {0, ..., classes - 1}
  std::vector<float> samples;        ///< row-major [n, length]
  std::vector<std::int32_t> labels;  ///< [n]

  [[nodiscard]] std::size_t size() const { return labels.size(); }
};

/// Every window by itself freed of its mean and scaled to unit standard deviation (of the n samples
/// themselves), so that the gain and offset of a recording do not give its class away.
/// `what` names the set in errors: "--test". Throws Error(bad_input) for a constant window.
LabelledWindows standardise(const signal::WindowSet& windows, const std::string& what);

}  // namespace piae::diagnosis
