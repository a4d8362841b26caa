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

/// The paper's classifier, WDCNN on the waveform. diagnosis/catalogue.hpp has the others.
inline constexpr const char* paper_classifier = "wdcnn";

/// What a classifier makes of the n test windows, before it decides.
struct Features {
  std::vector<float> hidden;  ///< row-major [n, width of the last hidden layer]
  std::vector<float> output;  ///< row-major [n, C]: the output layer, whose softmax are the scores
};

/// The content of diagnosis.h5 (kind "diagnosis"): one classifier, trained once or not at all, and
/// what it said of the test windows A.
struct DiagnosisRecord {
  signal::DatasetInfo info;
  std::string method;  ///< which generated the windows; "none" where there are none
  std::string classifier = paper_classifier;  ///< as the grid names it
  std::string ratio;                          ///< as the grid names it, "2to1" (scoring/ratios.hpp)
  std::int64_t generated_per_class = 0;       ///< windows of each fault class
  /// healthy windows to those of one fault class: 3.33 for "2to1"; nothing where there are none
  std::optional<double> true_ratio;
  bool any_known = true;  ///< whether fault windows were known
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the split
  std::vector<Label> labels;                             ///< [n] true classes of the windows of A
  std::vector<Label> predictions;                        ///< [n]
  /// row-major [n, C]: softmax, or 1 for the class that is named where nothing is said of the
  /// others
  std::vector<float> scores;
  std::vector<double> loss;            ///< [epochs] mean training loss; none where nothing trains
  std::vector<double> train_accuracy;  ///< [epochs] in [0, 1]
  /// Training throughput. It is left out where a run must give the same bytes each time, because
  /// elapsed time differs from run to run.
  std::optional<double> train_windows_per_second;
  std::optional<Features> features;  ///< where they are kept

  [[nodiscard]] Confusion confusion() const {
    return confusion_matrix(labels, predictions, info.classes.size());
  }
  /// In [0, 1], eq. 29.
  [[nodiscard]] double accuracy() const { return scoring::accuracy(confusion()); }
};

/// In the artefact: attributes of the root, those of DatasetInfo and `method`, `ratio`,
/// `generated_per_class`, `true_ratio` where there were fault windows, `known_per_class` (0) where
/// none was known, `seed`, `protocol`, `accuracy`, `classifier` unless it is the paper's, and where
/// measured `train_windows_per_second`; datasets /labels, /predictions int32
/// [n], /confusion int64 [C, C], /scores float32 [n, C], /curves/loss, /curves/train_accuracy
/// float64 [epochs], and where they are kept /features/hidden, /features/output float32 [n, width].
/// Throws std::logic_error when the lengths do not fit each other.
void write(artefact::Writer& writer, const DiagnosisRecord& record);
/// Throws artefact::Refusal for labels that no class has, for shapes that do not fit each other,
/// and for a confusion matrix or an accuracy that the predictions do not give.
DiagnosisRecord read_diagnosis(const artefact::Reader& reader);

}  // namespace piae::scoring
