#pragma once

#include <map>
#include <string>

#include "artefact/writer.hpp"
#include "diagnosis/kept_classifier.hpp"

namespace piae::diagnosis {

/// Trust in a kept classifier, measured on windows A, which it was not trained on.
struct Trust {
  double accuracy = 0;  ///< in [0, 1]
  /// Expected calibration error (scoring/calibration.hpp) of its raw scores, and after the
  /// temperature; in [0, 1].
  double raw_calibration_error = 0;
  double calibration_error = 0;
  double called_unknown = 0;  ///< share of test windows called unknown, in [0, 1]; all were trained
  /// Results for a fault class as if it had not been trained: how well novelty separates its
  /// windows from those of the other classes (scoring/auroc.hpp), and the share of them called
  /// unknown.
  struct Untrained {
    double auroc = 0;
    double called_unknown = 0;
  };
  std::map<Label, Untrained> untrained;  ///< empty if novelty is unavailable
};

/// Measures the trust on the windows of each class.
Trust trust_in(KeptClassifier& kept, const signal::WindowSet& test);

/// Returns one line: how certain the classifier may be about new windows.
std::string summary_of(const KeptClassifier& kept, const Trust& trust);

/// Writes /trust with the first four as attributes, and /trust/untrained_class,
/// /trust/untrained_auroc, /trust/untrained_called_unknown.
void write(artefact::Writer& writer, const Trust& trust);
/// Reads the trust in a classifier of that data set. Throws artefact::Refusal for impossible
/// shares, and unless each fault class occurs once.
Trust read_trust(const artefact::Reader& reader, const signal::DatasetInfo& info);

}  // namespace piae::diagnosis
