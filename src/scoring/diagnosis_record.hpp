#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// The content of diagnosis.h5 (kind "diagnosis"): one classifier, trained once and tried on A.
struct DiagnosisRecord {
  signal::DatasetInfo info;
  std::string method;  ///< that generated the windows; "none" where there are none
  std::string ratio;   ///< as the grid names it, "2to1" (scoring/ratios.hpp)
  std::int64_t generated_per_class = 0;  ///< windows for each fault class
  double true_ratio = 0;  ///< normal windows to those of a fault class, 3.33 for "2to1"
  std::int64_t seed = 0;
  std::string protocol;                   ///< of the split: "random", "blocked"
  std::vector<std::int32_t> labels;       ///< [n] true classes of the windows of A
  std::vector<std::int32_t> predictions;  ///< [n]
  std::vector<float> scores;              ///< row-major [n, C], softmax
  std::vector<double> loss;               ///< [epochs] mean training loss
  std::vector<double> train_accuracy;     ///< [epochs] in [0, 1]
  /// Training throughput. Absent where a run must give the same bytes each time: elapsed time
  /// differs from run to run.
  std::optional<double> train_windows_per_second;

  [[nodiscard]] Confusion confusion() const {
    return confusion_matrix(labels, predictions, info.classes.size());
  }
  /// In [0, 1], eq. 29.
  [[nodiscard]] double accuracy() const { return scoring::accuracy(confusion()); }
};

/// In the artefact: attributes of the root, those of DatasetInfo and `method`, `ratio`,
/// `generated_per_class`, `true_ratio`, `seed`, `protocol`, `accuracy`, and where known
/// `train_windows_per_second`; datasets /labels, /predictions int32 [n], /confusion int64 [C, C],
/// /scores float32 [n, C], /curves/loss, /curves/train_accuracy float64 [epochs]. Throws
/// std::logic_error when the lengths do not fit each other.
void write(artefact::Writer& writer, const DiagnosisRecord& record);
/// Throws artefact::Refusal for labels that do not exist, shapes that do not fit each other, and a
/// confusion matrix or an accuracy that is not the one of the predictions.
DiagnosisRecord read_diagnosis(const artefact::Reader& reader);

}  // namespace piae::scoring
