#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Windows as a classifier sees them.
struct LabelledWindows {
  std::size_t length = 0;      ///< samples in a window
  std::size_t classes = 0;     ///< labels are in {0, ..., classes - 1}
  std::vector<float> samples;  ///< row-major [n, length]
  std::vector<Label> labels;   ///< [n]

  [[nodiscard]] std::size_t size() const { return labels.size(); }
};

/// Subtracts from each window its mean and divides it by its standard deviation (the root of the
/// mean of its squares), so that gain and offset of a recording do not give its class away. `what`
/// names the set in errors, such as "--test". Throws Error(bad_input) for a constant window.
LabelledWindows standardise(const signal::WindowSet& windows, const std::string& what);

}  // namespace piae::diagnosis
