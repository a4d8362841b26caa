#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Windows as a classifier's input.
struct LabelledWindows {
  std::size_t length = 0;      ///< samples of a window, or bands of its spectra
  std::size_t classes = 0;     ///< labels are in {0, ..., classes - 1}
  std::vector<float> samples;  ///< row-major [n, length]
  std::vector<Label> labels;   ///< [n]

  [[nodiscard]] std::size_t size() const { return labels.size(); }
};

/// Writes `values`, less their mean and divided by their standard deviation (the root of the mean
/// of their squares), to `to`. At least two values must differ.
void standardise(std::span<const float> values, float* to);

/// Throws Error(bad_input) for a window whose samples are all the same. `what` names the set in the
/// error, such as "--test".
void require_varying(const signal::WindowSet& windows, const std::string& what);

/// Throws Error(bad_input) for windows that do not have as many samples as those of the training.
/// `what` names the set in the error.
void require_length(const signal::WindowSet& windows, std::size_t trained, const std::string& what);

/// Throws Error(bad_input) if the speed of a generated window is not known (NaN, training_set.hpp).
/// `input` names in the error what needs the speeds.
void require_speeds(const signal::WindowSet& training, const std::string& input);

/// Subtracts the mean from each window and divides it by its standard deviation (the root of the
/// mean of its squares), so that gain and offset of a recording do not reveal its class. `what`
/// names the set in errors, such as "--test". Throws Error(bad_input) for a constant window.
LabelledWindows standardise(const signal::WindowSet& windows, const std::string& what);

}  // namespace piae::diagnosis
