#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnosis/classifier.hpp"
#include "diagnosis/nearest.hpp"

namespace piae::diagnosis {

/// All classifiers in the order of the tables, the paper's first (scoring/diagnosis_record.hpp).
/// This is the one place that knows them all.
std::span<const Classifier> classifiers();

/// The classifier of that name; null when there is none.
const Classifier* find_classifier(const std::string& name);

/// The same. Throws Error(usage), which lists the known names, for any other.
const Classifier& the_classifier(const std::string& name);

/// The names of the rules.
std::vector<std::string> rules();

/// Whose accuracy without any generated window stands beside all others: what needs neither a
/// generator nor a training.
inline constexpr const char* bar_classifier = nearest.name;

/// The names of all with what they are, for people: "wdcnn (the paper's, on the waveform), ...".
std::string list_of_classifiers();

}  // namespace piae::diagnosis
