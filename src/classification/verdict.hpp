#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "classification/recording.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "inspection/fault_lines.hpp"

namespace piae::classification {

/// A classifier's verdict on a recording, and the evidence for it.
struct Verdict {
  Recording recording;
  std::vector<double> start_s;         ///< [n] start of each window
  diagnosis::Predictions predictions;  ///< for each window
  bool can_refuse = true;  ///< false if novelty is unavailable (KeptClassifier::novelty())
  /// True if more than half of the windows resemble nothing in the training set.
  bool unknown = false;
  /// The class with the greatest mean probability over the known windows (over all if none is
  /// known), and this mean. Probabilities are not multiplied, because windows of one recording are
  /// alike.
  Label label = 0;
  double probability = 0;
  double share = 0;          ///< of the windows predicted as this class
  double share_unknown = 0;  ///< of the unknown windows
  // Evidence from the whole recording:
  inspection::EnvelopeSpectrum envelope;  ///< the part that a picture shows
  inspection::FaultLines lines;

  [[nodiscard]] bool is_unknown(std::size_t window) const {
    return predictions.novelty[window] > diagnosis::highest_known_novelty;
  }
};

Verdict judge(Recording recording, diagnosis::KeptClassifier& classifier, std::size_t step);

}  // namespace piae::classification
