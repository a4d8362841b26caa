#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "run/grid.hpp"
#include "run/tested_windows.hpp"
#include "scoring/accuracy.hpp"
#include "scoring/confidence.hpp"
#include "scoring/decisions.hpp"
#include "scoring/quality_record.hpp"
#include "signal/dataset_info.hpp"
#include "signal/protocol.hpp"

namespace piae::run {

/// What tables need of one diagnosis.h5.
struct Diagnosis {
  std::string method;
  std::string ratio;
  std::string classifier = scoring::paper_classifier;
  std::int64_t seed = 0;
  std::int64_t generated_per_class = 0;
  /// healthy windows to those of one fault class; nothing where there are none
  std::optional<double> true_ratio = std::nullopt;
  bool any_known = true;  ///< whether fault windows were known
  signal::Protocol protocol = signal::Protocol::random;
  double accuracy = 0;  ///< in [0, 1]
  /// In [0, 1] (scoring/kind_accuracy.hpp), where conditions are told apart and classes have a kind
  /// of defect in common; else it says nothing, or nothing new.
  std::optional<double> kind_accuracy = std::nullopt;
  /// The tested speed divided by the known one, where the tested faults are known in other
  /// conditions alone (signal::is_transfer); 1 where these differ in something else.
  std::optional<double> speed_ratio = std::nullopt;
  /// The names of the conditions in which faults are known, and tested; empty as speed_ratio is.
  std::vector<std::string> known_at = {};
  std::vector<std::string> tested_at = {};
  scoring::Confidence confidence = {};
  std::vector<signal::ClassInfo> classes = {};
  scoring::Confusion confusion = {};  ///< of these classes
  /// Over several windows; empty where it is not known where the test windows were cut.
  std::vector<scoring::DecisionRates> decisions = {};
};

/// Reads one diagnosis. Throws artefact::Refusal where the file is not of this dataset, method,
/// ratio, classifier and seed, which are those of its place in the run, is not a diagnosis that
/// can be, or is not of these test windows. `tested` may be null, where they are not known.
Diagnosis read_diagnosis_cell(const artefact::Reader& reader, const std::string& dataset,
                              const Combination& combination, std::int64_t seed,
                              const TestedWindows* tested = nullptr);

/// Reads one score, in the same way.
scoring::QualityRecord read_score_cell(const artefact::Reader& reader, const std::string& dataset,
                                       const std::string& method, std::int64_t seed);

/// Throws artefact::Refusal where a file holds another value than the needed one. `what` names the
/// value, such as "the seed".
void require_same(const artefact::Reader& reader, const std::string& what, const std::string& holds,
                  const std::string& needed);

}  // namespace piae::run
