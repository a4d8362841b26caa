#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnosis/standardise.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// One entry of the catalogue of classifiers.
struct Classifier {
  const char* name;   ///< the name in CLASSIFIERS, in folders and in tables
  const char* what;   ///< what it is, in one phrase
  const char* input;  ///< what it is shown of a window
  /// Windows as WDCNN sees them, in which `what` names the set in errors; null for the one that is
  /// not trained (diagnosis/nearest.hpp).
  LabelledWindows (*represent)(const signal::WindowSet& windows, const std::string& what) = nullptr;
  /// Learns from healthy windows alone: it needs no fault window, known or generated, and is run
  /// with `none` only.
  bool rule = false;

  [[nodiscard]] bool trains() const { return represent != nullptr; }
};

/// All classifiers in the order of the tables, the paper's first (scoring/diagnosis_record.hpp).
/// This is the one place that knows them: programs look here, and make asks a program.
std::span<const Classifier> classifiers();

/// The classifier of that name; null when there is none.
const Classifier* find_classifier(const std::string& name);

/// The same. Throws Error(usage), which lists the known names, for any other.
const Classifier& the_classifier(const std::string& name);

/// The names of the rules.
std::vector<std::string> rules();

/// Whose accuracy without any generated window stands beside all others: what needs neither a
/// generator nor a training.
inline constexpr const char* bar_classifier = "nearest";

/// The names of all with what they are, for people: "wdcnn (the paper's, on the waveform), ...".
std::string list_of_classifiers();

}  // namespace piae::diagnosis
