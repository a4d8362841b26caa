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

/// Symptoms as a network's input: a row for each window.
using SymptomRows = Eigen::Matrix<double, Eigen::Dynamic,
                                  static_cast<int>(symptoms::number_of_symptoms), Eigen::RowMajor>;

/// Makes a row for each window: its symptoms, less their mean over the training windows, divided by
/// their standard deviation there, clipped to -4 .. 4. Each window is measured at its own shaft
/// speed.
class SymptomScale {
 public:
  /// Learns from the windows of B (`normal`) and all fault windows in `training`. The novelty of a
  /// healthy training window is computed without its block of B, because tested windows are not in
  /// the baseline either. Throws Error(bad_input) if the speed of a generated window is not known
  /// (NaN, training_set.hpp), and as symptoms::measure() and symptoms::Baselines do.
  SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training);

  /// Return the rows and labels of the training windows, healthy ones first.
  [[nodiscard]] const SymptomRows& training() const { return training_; }
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }

  /// Returns the rows of any windows. `what` names the windows in errors.
  SymptomRows rows_of(const signal::WindowSet& windows, const std::string& what);

  /// Writes all that rows_of() needs, below a group: what symptoms::Baselines writes, /mean and
  /// /deviation.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Reads the scale of windows at this sample rate, without training windows. Throws
  /// artefact::Refusal as symptoms::Baselines does, and for a deviation that is not above 0.
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
