#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/folds.hpp"
#include "diagnosis/inputs.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "diagnosis/learning_settings.hpp"
#include "scoring/diagnosis_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::diagnosis {

/// The classifier of one grid cell, and its training settings.
struct Task {
  const Classifier& classifier;
  const scoring::Ratio& ratio;
  std::int64_t seed = 0;  ///< part of the random stream's name, with data set and ratio
  LearningSettings settings = {};
  bool keep_features = false;  ///< true if record() includes the output of the last layers
};

/// One cell of the grid: trains a classifier on B, C and the ratio's number of windows of E, and
/// tests it on A (paper, Section 4.3.2).
class Diagnosis {
 public:
  /// Throws as compose_training_set(), require_faults() and require_fitting_test_set() do, where
  /// `known_file` names C. Throws Error(usage) if features of a classifier without layers are
  /// requested, for a rule with generated windows, for prewhitening without symptoms, and for
  /// unlabelled windows that are missing or not used.
  Diagnosis(Task task, Inputs inputs, const std::string& known_file);

  /// Returns the epochs of learn(), plus those of keep() if the classifier is to be kept.
  [[nodiscard]] std::size_t epochs(bool is_kept) const;

  /// Throws as diagnosis::learn() does.
  void learn(const EpochDone& epoch_done = {});

  /// Writes diagnosis.h5: the predictions for the windows of A, and the course of the training.
  /// Returns one line: the accuracy and the number of windows. `reproducible` leaves out the
  /// training speed, which differs between runs.
  [[nodiscard]] std::string write(artefact::Writer& writer, bool reproducible);

  /// Writes classifier.h5: the trained classifier and its trust, measured on A (trust.hpp). Returns
  /// one line about the trust. Retrains without each left-out fold (keep.hpp); call no other member
  /// afterwards.
  [[nodiscard]] std::string write_classifier(artefact::Writer& writer,
                                             const EpochDone& epoch_done = {});

 private:
  [[nodiscard]] scoring::DiagnosisRecord record();
  [[nodiscard]] std::string summary_of(const scoring::DiagnosisRecord& record) const;
  [[nodiscard]] KeptClassifier keep(const EpochDone& epoch_done);
  [[nodiscard]] Lessons lessons() const;
  [[nodiscard]] LearningSettings settings() const;
  [[nodiscard]] std::optional<double> windows_per_second() const;

  Task task_;
  Inputs inputs_;
  signal::WindowSet training_set_;
  Stream stream_;
  Learned learned_;
};

}  // namespace piae::diagnosis
