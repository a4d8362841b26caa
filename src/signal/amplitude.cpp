#include "signal/amplitude.hpp"

#include <cmath>
#include <numeric>

#include "base/error.hpp"

namespace piae::signal {

double mean_of(std::span<const float> window) {
  double sum = 0;
  for (const float x : window) sum += x;
  return sum / static_cast<double>(window.size());
}

double rms_of(std::span<const double> signal) {
  const auto n = static_cast<double>(signal.size());
  const double mean = std::accumulate(signal.begin(), signal.end(), 0.0) / n;
  double squares = 0;
  for (const double x : signal) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / n);
}

std::vector<double> rms_by_class(const WindowSet& windows) {
  std::vector<double> rms;
  for (const Label label : windows.info.labels()) {
    const std::vector<std::size_t> members = windows.indices_of(label);
    double squares = 0;
    for (const std::size_t i : members) {
      const double mean = mean_of(windows.window(i));
      for (const float x : windows.window(i)) squares += (x - mean) * (x - mean);
    }
    if (members.empty()) {
      rms.push_back(1);
    } else if (squares > 0) {
      rms.push_back(std::sqrt(squares / static_cast<double>(members.size() * windows.length)));
    } else {
      throw Error(Exit::bad_input, "class " + windows.info.class_of(label).name +
                                       ": its known windows are constant; check the recording");
    }
  }
  return rms;
}

}  // namespace piae::signal
