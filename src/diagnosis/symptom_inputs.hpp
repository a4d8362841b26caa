#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "diagnosis/symptom_standard.hpp"
#include "signal/window_set.hpp"
#include "symptoms/baseline.hpp"

namespace piae::diagnosis {

/// Makes a row for each window: its symptoms against the healthy windows of its machine, scaled by
/// those of the training windows (symptom_standard.hpp). Each window is measured at its own shaft
/// speed.
class SymptomScale {
 public:
  /// Learns from the windows of B (`normal`) and all fault windows in `training`. The novelty of a
  /// healthy training window is computed without its block of B, because tested windows are not in
  /// the baseline either. Throws Error(bad_input) if the speed of a generated window is not known
  /// (NaN, training_set.hpp), and as symptoms::measure() and symptoms::Baselines do.
  SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
               double prewhitening);

  /// Takes the standard of other machines, without training windows. Throws as symptoms::measure()
  /// and symptoms::Baselines do.
  SymptomScale(const signal::WindowSet& normal, SymptomStandard standard, double prewhitening);

  /// Return the rows and labels of the training windows, healthy ones first.
  [[nodiscard]] const SymptomRows& training() const { return training_; }
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }

  /// Returns the rows of any windows. `what` names the windows in errors.
  SymptomRows rows_of(const signal::WindowSet& windows, const std::string& what);

  /// Writes all that rows_of() needs, below a group: what symptoms::Baselines and SymptomStandard
  /// write.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Reads the scale of windows at this sample rate, without training windows. Throws
  /// artefact::Refusal as symptoms::Baselines and SymptomStandard do.
  SymptomScale(const artefact::Reader& reader, const std::string& group, double rate_hz);

 private:
  SymptomScale(const signal::WindowSet& normal, const signal::WindowSet& training,
               double prewhitening, const std::vector<symptoms::Measures>& of_normal);
  SymptomRows raw_rows_of(const signal::WindowSet& windows, const std::string& what);
  SymptomRows training_rows(const signal::WindowSet& normal, const signal::WindowSet& training,
                            const std::vector<symptoms::Measures>& of_normal);

  symptoms::Baselines baselines_;
  std::vector<Label> labels_;
  SymptomRows training_;
  SymptomStandard standard_;
};

}  // namespace piae::diagnosis
