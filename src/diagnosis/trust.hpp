#pragma once

#include <map>
#include <string>

#include "artefact/writer.hpp"
#include "diagnosis/kept_classifier.hpp"

namespace piae::diagnosis {

/// How far a kept classifier is to be believed, by windows that it was not trained on, A.
struct Trust {
  double accuracy = 0;  ///< in [0, 1]
  /// Expected calibration error (scoring/calibration.hpp) of its scores as they are, and by the
  /// temperature; in [0, 1].
  double raw_calibration_error = 0;
  double calibration_error = 0;
  double called_unknown = 0;  ///< share of these windows, all of which were trained, in [0, 1]
  /// If a class of fault had not been trained: how well strangeness tells its windows from those of
  /// the other classes (scoring/auroc.hpp), and which share of them is called unknown.
  struct Untrained {
    double auroc = 0;
    double called_unknown = 0;
  };
  std::map<Label, Untrained> untrained;  ///< empty where it cannot be told what is strange
};

/// By windows of each class.
Trust trust_in(KeptClassifier& kept, const signal::WindowSet& test);

/// One line: how sure it may be of windows that it has not seen.
std::string summary_of(const KeptClassifier& kept, const Trust& trust);

/// In the artefact: /trust with the first four as attributes, and /trust/untrained_class,
/// /trust/untrained_auroc, /trust/untrained_called_unknown.
void write(artefact::Writer& writer, const Trust& trust);
/// Of a classifier of that data set. Throws artefact::Refusal for shares that cannot be, and where
/// not each class of fault is named once.
Trust read_trust(const artefact::Reader& reader, const signal::DatasetInfo& info);

}  // namespace piae::diagnosis
