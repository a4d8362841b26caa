#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "diagnosis/catalogue.hpp"
#include "diagnosis/novelty.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Origin of a kept classifier, for later readers.
struct ClassifierOrigin {
  std::string method;  ///< method that generated its training windows; "none" without them
  std::string ratio;
  std::int64_t generated_per_class = 0;
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;
  std::int64_t training_windows = 0;  ///< set by keep(), like the next
  std::string training_digest = {};   ///< sha256 of the samples and labels of the training set
};

/// Calibration of probabilities: softmax of logits divided by a temperature.
struct Calibration {
  double temperature = 1;
  std::int64_t windows = 0;  ///< number of left-out windows used to find it; 0 without calibration
};

/// Output of a kept classifier for n windows.
struct Predictions {
  std::vector<float> probabilities;  ///< row-major [n, classes], calibrated
  /// [n] novelty; above 1 a window resembles nothing in the training set; 0 if unavailable.
  std::vector<double> novelty;
  std::vector<Label> labels;  ///< [n] the class of the greatest probability
};

/// A classifier as `diagnose --keep-classifier` stores it in classifier.h5 (kind "classifier"). It
/// classifies new recordings of its machine without its training windows.
class KeptClassifier {
 public:
  KeptClassifier(signal::DatasetInfo info, std::size_t length, const Classifier& classifier,
                 std::unique_ptr<Trained> trained, Calibration calibration,
                 std::optional<Novelty> novelty, ClassifierOrigin origin);
  /// Throws artefact::Refusal for content that `diagnose` cannot have written, such as a classifier
  /// that cannot use windows of its length or gives outputs that are not finite.
  explicit KeptClassifier(const artefact::Reader& reader);

  /// Writes what DatasetInfo writes; the root attributes `classifier`, `input` (made from a
  /// window), `window_length`, `temperature`, `left_out_windows`, and those of ClassifierOrigin;
  /// /learned (Trained::write()); and /reference (Novelty::write()) if there is one.
  void write(artefact::Writer& writer) const;

  /// Classifies windows of its data set, length() samples each at the rate of info(). Throws as
  /// Trained::outputs() does.
  Predictions predict(const signal::WindowSet& windows);
  /// Returns hidden layer, logits and scores as the network gives them. predict() divides the
  /// logits by the temperature.
  Outputs uncalibrated(const signal::WindowSet& windows);

  [[nodiscard]] const signal::DatasetInfo& info() const { return info_; }
  [[nodiscard]] std::size_t length() const { return length_; }
  [[nodiscard]] const Classifier& classifier() const { return *classifier_; }
  [[nodiscard]] const Calibration& calibration() const { return calibration_; }
  [[nodiscard]] const ClassifierOrigin& origin() const { return origin_; }
  /// Returns the novelty; empty if no fault was known in the tested condition.
  [[nodiscard]] const std::optional<Novelty>& novelty() const { return novelty_; }

 private:
  void require_prediction(const artefact::Reader& reader);

  signal::DatasetInfo info_;
  std::size_t length_;  ///< samples per window
  const Classifier* classifier_;
  std::unique_ptr<Trained> trained_;
  Calibration calibration_;
  std::optional<Novelty> novelty_;
  ClassifierOrigin origin_;
};

}  // namespace piae::diagnosis
