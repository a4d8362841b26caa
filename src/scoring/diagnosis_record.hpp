#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"
#include "signal/protocol.hpp"

namespace piae::scoring {

/// The paper's classifier, WDCNN on the waveform. diagnosis/catalogue.hpp lists the others.
inline constexpr const char* paper_classifier = "wdcnn";

/// Output of a classifier's last layers for the n test windows.
struct Features {
  std::vector<float> hidden;  ///< row-major [n, width of the last hidden layer]
  /// row-major [n, C]: the output layer, before the softmax that gives the scores
  std::vector<float> output;
};

/// The content of diagnosis.h5 (kind "diagnosis"): one classifier, trained once or not at all, and
/// its predictions for the test windows A.
struct DiagnosisRecord {
  signal::DatasetInfo info;
  std::string method;  ///< method that generated the windows; "none" without generated windows
  std::string classifier = paper_classifier;  ///< name in the grid
  std::string ratio;                          ///< name in the grid, "2to1" (scoring/ratios.hpp)
  std::int64_t generated_per_class = 0;       ///< per fault class
  /// healthy windows to those of one fault class: 3.33 for "2to1"; empty without fault windows
  std::optional<double> true_ratio;
  bool any_known = true;  ///< true if fault windows were known
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the split
  std::vector<Label> labels;                             ///< [n] true classes of the windows of A
  std::vector<Label> predictions;                        ///< [n]
  /// row-major [n, C]: softmax, or 1 for the predicted class if the classifier gives no scores
  std::vector<float> scores;
  std::vector<double> loss;            ///< [epochs] mean training loss; empty without training
  std::vector<double> train_accuracy;  ///< [epochs] in [0, 1]
  /// Training throughput. It is left out if a run must reproduce the same bytes, because elapsed
  /// time differs between runs.
  std::optional<double> train_windows_per_second;
  std::optional<Features> features;  ///< if kept

  [[nodiscard]] Confusion confusion() const {
    return confusion_matrix(labels, predictions, info.classes.size());
  }
  /// Returns the accuracy in [0, 1], eq. 29.
  [[nodiscard]] double accuracy() const { return scoring::accuracy(confusion()); }
};

/// Writes the root attributes of DatasetInfo and `method`, `ratio`, `generated_per_class`,
/// `true_ratio` if there were fault windows, `known_per_class` (0) if no fault window was known,
/// `seed`, `protocol`, `accuracy`, `classifier` unless it is the paper's, and
/// `train_windows_per_second` if measured; the datasets /labels, /predictions int32 [n], /confusion
/// int64 [C, C], /scores float32 [n, C], /curves/loss, /curves/train_accuracy float64 [epochs];
/// and, if features are kept, /features/hidden, /features/output float32 [n, width]. Throws
/// std::logic_error if the lengths do not match.
void write(artefact::Writer& writer, const DiagnosisRecord& record);
/// Throws artefact::Refusal for labels without a class, for shapes that do not match, and if the
/// confusion matrix or the accuracy contradicts the predictions.
DiagnosisRecord read_diagnosis(const artefact::Reader& reader);

}  // namespace piae::scoring
