#include "diagnosis/standardise.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "signal/amplitude.hpp"

namespace piae::diagnosis {

void standardise(std::span<const float> values, float* to) {
  const double mean = signal::mean_of(values);
  double squares = 0;
  for (const float x : values) squares += (x - mean) * (x - mean);
  const double scale = 1 / std::sqrt(squares / static_cast<double>(values.size()));
  for (const float x : values) *to++ = static_cast<float>((x - mean) * scale);
}

void require_varying(const signal::WindowSet& windows, const std::string& what) {
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (!signal::is_constant(windows.window(i))) continue;
    throw Error(Exit::bad_input,
                what + ": window " + std::to_string(i) + " (class " +
                    windows.info.classes[index_of(windows.labels[i])].name +
                    ") is constant and cannot be scaled to unit standard deviation; "
                    "a window needs two different samples or more: cut dead stretches out of the "
                    "recordings");
  }
}

void require_length(const signal::WindowSet& windows, std::size_t trained,
                    const std::string& what) {
  if (windows.length == trained) return;
  throw Error(Exit::bad_input,
              fmt::format("{}: windows of {} samples, but the training windows have {}; both "
                          "must be the same: give files of one split",
                          what, windows.length, trained));
}

void require_speeds(const signal::WindowSet& training, const std::string& input) {
  if (std::ranges::none_of(training.shaft_speed_rpm, [](double rpm) { return std::isnan(rpm); })) {
    return;
  }
  throw Error(
      Exit::bad_input,
      fmt::format("--generated: the windows lack shaft speeds, which {} needs in a data set "
                  "with several speeds; use a method that stores them, such as "
                  "strike-twin or piae-dt-zero, or another --classifier",
                  input));
}

LabelledWindows standardise(const signal::WindowSet& windows, const std::string& what) {
  require_varying(windows, what);
  LabelledWindows result;
  result.length = windows.length;
  result.classes = windows.info.classes.size();
  result.labels = windows.labels;
  result.samples.resize(windows.samples.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    standardise(windows.window(i), result.samples.data() + i * windows.length);
  }
  return result;
}

}  // namespace piae::diagnosis
