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

  /// Writes diagnosis.h5: the answers to the windows of A, and the course of the training. Returns
  /// one line: how well it named how many windows. `reproducible` leaves out the speed of the
  /// training, which differs from run to run.
  [[nodiscard]] std::string write(artefact::Writer& writer, bool reproducible);

  /// Writes classifier.h5: what has learned, and by A how far it is to be believed (trust.hpp).
  /// Returns one line about that. It learns again without each fold that is left out (keep.hpp);
  /// nothing else can be called afterwards.
  [[nodiscard]] std::string write_classifier(artefact::Writer& writer,
                                             const EpochDone& epoch_done = {});

 private:
  [[nodiscard]] scoring::DiagnosisRecord record();
  [[nodiscard]] std::string summary_of(const scoring::DiagnosisRecord& record) const;
  [[nodiscard]] KeptClassifier keep(const EpochDone& epoch_done);
  [[nodiscard]] Lessons lessons() const;
  [[nodiscard]] std::optional<double> windows_per_second() const;

  Task task_;
  Inputs inputs_;
  signal::WindowSet training_set_;
  Stream stream_;
  Learned learned_;
};

}  // namespace piae::diagnosis
