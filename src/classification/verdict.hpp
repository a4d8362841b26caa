#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "classification/recording.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "inspection/fault_lines.hpp"

namespace piae::classification {

/// What a classifier says of a recording, and what speaks for it.
struct Verdict {
  Recording recording;
  std::vector<double> start_s;  ///< [n] of each window
  diagnosis::Answers answers;   ///< of each window
  bool tells_unknown = true;    ///< else nothing can be unknown (KeptClassifier::strangeness())
  /// Of the whole recording: more than half of its windows look like nothing that was trained.
  bool unknown = false;
  /// The class with the greatest probability in the mean over the windows (of those that are known,
  /// unless none is), and that mean. Windows of one recording are alike, so their probabilities are
  /// not multiplied.
  Label label = 0;
  double probability = 0;
  double share = 0;          ///< of the windows that name this class
  double share_unknown = 0;  ///< of the windows
  // The evidence, of the whole recording:
  inspection::EnvelopeSpectrum envelope;  ///< as far as a picture shows it
  inspection::FaultLines lines;

  [[nodiscard]] bool is_unknown(std::size_t window) const {
    return answers.strangeness[window] > diagnosis::strangest_known;
  }
};

Verdict judge(Recording recording, diagnosis::KeptClassifier& classifier, std::size_t step);

}  // namespace piae::classification
