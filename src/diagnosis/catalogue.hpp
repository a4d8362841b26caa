#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnosis/classifier.hpp"
#include "diagnosis/nearest.hpp"

namespace piae::diagnosis {

/// Returns all classifiers in the order of the tables, the paper's first
/// (scoring/diagnosis_record.hpp). Only this table knows all of them.
std::span<const Classifier> classifiers();

/// Returns the classifier of that name; null if there is none.
const Classifier* find_classifier(const std::string& name);

/// Returns the classifier of that name. Throws Error(usage), which lists the known names, if there
/// is none.
const Classifier& the_classifier(const std::string& name);

/// Returns the name of a classifier for readers: "wdcnn", or "dann (sees D)" for one that adapts
/// and so gets more than the others.
std::string marked_name(const std::string& classifier);

/// Returns the names of the rules.
std::vector<std::string> rules();

/// Baseline classifier: its accuracy without generated windows is shown next to all others, because
/// it needs neither a generator nor a training.
inline constexpr const char* reference_classifier = nearest.name;

/// Returns all names with their descriptions, as text: "wdcnn (the paper's, on the waveform), ...".
std::string list_of_classifiers();

}  // namespace piae::diagnosis
