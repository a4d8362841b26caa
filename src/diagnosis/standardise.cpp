#include "diagnosis/standardise.hpp"

#include <cmath>
#include <span>

#include "base/error.hpp"
#include "signal/amplitude.hpp"

namespace piae::diagnosis {

namespace {

void standardise(std::span<const float> window, float* to) {
  const double mean = signal::mean_of(window);
  double squares = 0;
  for (const float x : window) squares += (x - mean) * (x - mean);
  const double scale = 1 / std::sqrt(squares / static_cast<double>(window.size()));
  for (const float x : window) *to++ = static_cast<float>((x - mean) * scale);
}

}  // namespace

LabelledWindows standardise(const signal::WindowSet& windows, const std::string& what) {
  LabelledWindows result;
  result.length = windows.length;
  result.classes = windows.info.classes.size();
  result.labels = windows.labels;
  result.samples.resize(windows.samples.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const std::span<const float> window = windows.window(i);
    if (signal::is_constant(window)) {
      throw Error(Exit::bad_input,
                  what + ": window " + std::to_string(i) + " (class " +
                      windows.info.classes[index_of(windows.labels[i])].name +
                      ") is constant and cannot be scaled to unit standard deviation; "
                      "a window needs at least two different samples");
    }
    standardise(window, result.samples.data() + i * windows.length);
  }
  return result;
}

}  // namespace piae::diagnosis
