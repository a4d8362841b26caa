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

/// Contents of one diagnosis.h5 that tables need.
struct Diagnosis {
  std::string method;
  std::string ratio;
  std::string classifier = scoring::paper_classifier;
  std::int64_t seed = 0;
  std::int64_t generated_per_class = 0;
  /// healthy windows per window of one fault class; empty without fault windows
  std::optional<double> true_ratio = std::nullopt;
  bool any_known = true;  ///< true if fault windows were known
  signal::Protocol protocol = signal::Protocol::random;
  double accuracy = 0;  ///< in [0, 1]
  /// In [0, 1] (scoring/type_accuracy.hpp). Set only if conditions are told apart and several
  /// classes share a fault type.
  std::optional<double> type_accuracy = std::nullopt;
  /// Tested speed divided by known speed, if the tested faults are known in other conditions only
  /// (signal::is_transfer); 1 if the conditions differ in something else.
  std::optional<double> speed_ratio = std::nullopt;
  /// Conditions in which faults are known, and tested. Empty where speed_ratio is empty.
  std::vector<std::string> known_at = {};
  std::vector<std::string> tested_at = {};
  scoring::Confidence confidence = {};
  std::vector<signal::ClassInfo> classes = {};
  scoring::Confusion confusion = {};  ///< of `classes`
  /// Decisions over several windows; empty if the places of the test windows are unknown.
  std::vector<scoring::DecisionRates> decisions = {};
};

/// Reads one diagnosis. Throws artefact::Refusal if its data set, method, ratio, classifier or seed
/// differs from its place in the run, if its contents are impossible, or if it belongs to other
/// test windows. `tested` may be null if these are unknown.
Diagnosis read_diagnosis_cell(const artefact::Reader& reader, const std::string& dataset,
                              const Combination& combination, std::int64_t seed,
                              const TestedWindows* tested = nullptr);

/// Reads one score, with the same checks.
scoring::QualityRecord read_score_cell(const artefact::Reader& reader, const std::string& dataset,
                                       const std::string& method, std::int64_t seed);

/// Throws artefact::Refusal if the file holds another value than the needed one. `what` names the
/// value, such as "the seed".
void require_same(const artefact::Reader& reader, const std::string& what, const std::string& holds,
                  const std::string& needed);

}  // namespace piae::run
