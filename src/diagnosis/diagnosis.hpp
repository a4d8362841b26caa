#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/folds.hpp"
#include "diagnosis/inputs.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::diagnosis {

/// The classifier of one cell of the grid, and how it learns.
struct Task {
  const Classifier& classifier;
  const scoring::Ratio& ratio;
  std::int64_t seed = 0;  ///< names the random stream, with data set and ratio
  WdcnnOptions options = {};
  MakeWdcnnBackend make_backend = {};  ///< of a WDCNN
  bool keep_features = false;          ///< whether record() has the last layers' answers
};

/// One cell of the grid: a classifier learns from B, C and the windows of E that the ratio asks
/// for, and is tried on A (paper, Section 4.3.2).
class Diagnosis {
 public:
  /// Throws as compose_training_set(), require_faults() and require_fitting_test_set() do, where
  /// `known_file` names C; Error(usage) for features of a classifier without layers, and for
  /// generated windows and a rule.
  Diagnosis(Task task, Inputs inputs, const std::string& known_file);

  /// The epochs of learn(), and of keep() where the classifier is to be kept.
  [[nodiscard]] std::size_t epochs(bool is_kept) const;

  /// Throws as diagnosis::learn() does.
  void learn(const EpochDone& epoch_done = {});

  /// The answers to the windows of A, and the course of the training.
  [[nodiscard]] scoring::DiagnosisRecord record();
  /// One line of a record: how well it named how many windows.
  [[nodiscard]] std::string summary_of(const scoring::DiagnosisRecord& record) const;

  /// Makes the classifier ready to be kept (keep.hpp); record() comes before. It learns anew
  /// without each fold that is left out.
  [[nodiscard]] KeptClassifier keep(const EpochDone& epoch_done = {});

  [[nodiscard]] const Inputs& inputs() const { return inputs_; }

 private:
  [[nodiscard]] Lessons lessons() const;
  [[nodiscard]] std::optional<double> windows_per_second() const;

  Task task_;
  Inputs inputs_;
  signal::WindowSet training_set_;
  Stream stream_;
  Learned learned_;
};

}  // namespace piae::diagnosis
