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
#include "diagnosis/strangeness.hpp"
#include "signal/protocol.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// How a kept classifier came to be, for who finds it later.
struct ClassifierOrigin {
  std::string
      method;  ///< which generated windows that it was trained on; "none" where there are none
  std::string ratio;
  std::int64_t generated_per_class = 0;
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;
  std::int64_t training_windows = 0;  ///< this and the next: keep() finds them
  std::string training_digest = {};   ///< sha256 of the samples and labels of the training set
};

/// Probabilities that mean what they say: softmax of logits by a temperature.
struct Calibration {
  double temperature = 1;
  std::int64_t windows = 0;  ///< that were left out to find it; 0 where it could not be found
};

/// What a kept classifier says of n windows.
struct Answers {
  std::vector<float> probabilities;  ///< row-major [n, classes], calibrated
  /// [n] above 1 a window looks like nothing that was trained; 0 where that cannot be told.
  std::vector<double> strangeness;
  std::vector<Label> labels;  ///< [n] the class of the greatest probability
};

/// A classifier as `diagnose --keep-classifier` stores it in classifier.h5 (kind "classifier"): it
/// can be asked about new recordings of its machine, without its training windows.
class KeptClassifier {
 public:
  KeptClassifier(signal::DatasetInfo info, std::size_t length, const Classifier& classifier,
                 std::unique_ptr<Trained> trained, Calibration calibration,
                 std::optional<Strangeness> strangeness, ClassifierOrigin origin);
  /// Throws artefact::Refusal for what `diagnose` cannot have written, such as one that cannot be
  /// asked about windows of its length, or has no finite answer.
  explicit KeptClassifier(const artefact::Reader& reader);

  /// In the artefact: what DatasetInfo writes; attributes of the root `classifier`, `input` (what
  /// it is shown of a window), `window_length`, `temperature`, `left_out_windows`, and those of
  /// ClassifierOrigin; /learned (Trained::write()) and, where there is one, /reference
  /// (Strangeness::write()).
  void write(artefact::Writer& writer) const;

  /// Windows of its data set, length() samples each at the rate of info(). Throws as
  /// Trained::outputs() does.
  Answers answer(const signal::WindowSet& windows);
  /// The same without a temperature.
  Outputs uncalibrated(const signal::WindowSet& windows);

  [[nodiscard]] const signal::DatasetInfo& info() const { return info_; }
  [[nodiscard]] std::size_t length() const { return length_; }
  [[nodiscard]] const Classifier& classifier() const { return *classifier_; }
  [[nodiscard]] const Calibration& calibration() const { return calibration_; }
  [[nodiscard]] const ClassifierOrigin& origin() const { return origin_; }
  /// None where no fault was known in the tested condition: then it cannot be told what is strange.
  [[nodiscard]] const std::optional<Strangeness>& strangeness() const { return strangeness_; }

 private:
  void require_answer(const artefact::Reader& reader);

  signal::DatasetInfo info_;
  std::size_t length_;  ///< samples in a window
  const Classifier* classifier_;
  std::unique_ptr<Trained> trained_;
  Calibration calibration_;
  std::optional<Strangeness> strangeness_;
  ClassifierOrigin origin_;
};

}  // namespace piae::diagnosis
