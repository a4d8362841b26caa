#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "signal/window_set.hpp"
#include "symptoms/baseline.hpp"
#include "symptoms/symptoms.hpp"

namespace piae::diagnosis {

/// Symptoms as a network sees them: a row for each window.
using SymptomRows = Eigen::Matrix<double, Eigen::Dynamic,
                                  static_cast<int>(symptoms::number_of_symptoms), Eigen::RowMajor>;

/// Makes rows of windows: their symptoms, each less its mean over the training windows and by its
/// standard deviation there, clipped to -4 .. 4. Each window is measured at the speed of the shaft
/// that it says.
class SymptomScale {
 public:
  /// Learns from the windows of B (`normal`) and all fault windows in `training`. A healthy
  /// training window has the novelty of when its block of B is left out, since no window that is
  /// tested is in the baseline either. Throws Error(bad_input) where the speed of a generated
  /// window is not known (NaN, training_set.hpp), and as symptoms::measure() and
  /// symptoms::Baselines do.
  SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training);

  /// Of the training windows: first the healthy ones, then the others.
  [[nodiscard]] const SymptomRows& training() const { return training_; }
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }

  /// Of any windows. `what` names them in errors.
  SymptomRows rows_of(const signal::WindowSet& windows, const std::string& what);

  /// All that rows_of() needs, below a group: what symptoms::Baselines writes, /mean and
  /// /deviation.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Of windows at this sample rate. It has no training windows. Throws artefact::Refusal as
  /// symptoms::Baselines does, and for a deviation that is not above 0.
  SymptomScale(const artefact::Reader& reader, const std::string& group, double rate_hz);

 private:
  using Row = Eigen::RowVectorXd;
  SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
               const std::vector<symptoms::Measures>& of_normal);
  SymptomRows raw_rows_of(const signal::WindowSet& windows, const std::string& what);
  [[nodiscard]] SymptomRows scaled(const SymptomRows& rows) const;

  symptoms::Baselines baselines_;
  SymptomRows training_;
  std::vector<Label> labels_;
  Row mean_;
  Row deviation_;
};

}  // namespace piae::diagnosis
