#include "twin/scaling.hpp"

#include <torch/torch.h>

#include <cmath>

#include "base/error.hpp"

namespace piae::twin {

namespace {

double mean_of(std::span<const float> window) {
  double sum = 0;
  for (const float x : window) sum += x;
  return sum / static_cast<double>(window.size());
}

}  // namespace

std::vector<double> rms_by_class(const signal::WindowSet& windows) {
  std::vector<double> scale;
  for (std::size_t label = 0; label < windows.info.classes.size(); ++label) {
    const std::vector<std::size_t> members = windows.indices_of(static_cast<int>(label));
    double squares = 0;
    for (const std::size_t i : members) {
      const double mean = mean_of(windows.window(i));
      for (const float x : windows.window(i)) squares += (x - mean) * (x - mean);
    }
    if (members.empty()) {
      scale.push_back(1);
    } else if (squares > 0) {
      scale.push_back(std::sqrt(squares / static_cast<double>(members.size() * windows.length)));
    } else {
      throw Error(Exit::bad_input, "class " + windows.info.classes[label].name +
                                       ": its known windows are constant; check the recording");
    }
  }
  return scale;
}

torch::Tensor scaled_windows(const signal::WindowSet& windows, const std::vector<double>& scale) {
  std::vector<float> scaled;
  scaled.reserve(windows.samples.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double mean = mean_of(windows.window(i));
    const double unit = scale[static_cast<std::size_t>(windows.labels[i])];
    for (const float x : windows.window(i)) scaled.push_back(static_cast<float>((x - mean) / unit));
  }
  return torch::tensor(scaled).view(
      {static_cast<std::int64_t>(windows.size()), static_cast<std::int64_t>(windows.length)});
}

}  // namespace piae::twin
