#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/label.hpp"
#include "signal/window_set.hpp"
#include "symptoms/symptoms.hpp"

namespace piae::diagnosis {

/// Symptoms as a network sees them: a row for each window.
using SymptomRows = Eigen::Matrix<double, Eigen::Dynamic,
                                  static_cast<int>(symptoms::number_of_symptoms), Eigen::RowMajor>;

struct SymptomInputs {
  SymptomRows training;
  std::vector<Label> labels;  ///< of the training windows: first the healthy ones, then the others
  SymptomRows test;
};

/// The symptoms of the windows of B (`normal`), of all fault windows in `training`, and of the test
/// windows, each less the mean over the training windows and by their standard deviation, clipped
/// to -4 .. 4. A healthy training window has the novelty of when its block of B is left out, since
/// no window that is tested is in the baseline either. Each is measured at the speed of the shaft
/// that it says. Throws Error(bad_input) where that of a generated one is not known (NaN,
/// training_set.hpp), and as symptoms::measure() and symptoms::Baselines do.
SymptomInputs symptom_inputs(const signal::WindowSet& normal, const signal::WindowSet& training,
                             const signal::WindowSet& test);

}  // namespace piae::diagnosis
