#pragma once

#include <string>
#include <vector>

#include "classification/verdict.hpp"
#include "diagnosis/trust.hpp"

namespace piae::classification {

/// A table for a terminal, at most 80 columns wide: a row for each recording, with the class that
/// is named (or "unknown"), its probability, which share of the windows name it and which are
/// unknown, and how far the line of that fault stands out of the envelope spectrum. Where a
/// description says what a recording is, that stands beside. Of names that are too long for the
/// width their ends are shown.
std::string table_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info);

/// The classifier, what it was trained on, and how far it may be believed: four lines.
std::string origin_of(const diagnosis::KeptClassifier& kept, const diagnosis::Trust& trust);

/// A line for each window: recording, start_s, class, probability, strangeness, unknown (0 or 1),
/// and the probability of every class.
std::string csv_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info);

}  // namespace piae::classification
