#include "signal/scaling.hpp"

#include "signal/amplitude.hpp"

namespace piae::signal {

std::vector<float> scaled_windows(const WindowSet& windows, const std::vector<double>& scale) {
  std::vector<float> scaled;
  scaled.reserve(windows.samples.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double mean = mean_of(windows.window(i));
    const double unit = scale[index_of(windows.labels[i])];
    for (const float x : windows.window(i)) scaled.push_back(static_cast<float>((x - mean) / unit));
  }
  return scaled;
}

}  // namespace piae::signal
