#pragma once

#include <optional>
#include <string>
#include <vector>

#include "classification/verdict.hpp"
#include "diagnosis/trust.hpp"

namespace piae::classification {

/// Returns text such as "BPFI +12.3 dB": the line of the predicted fault, or for other classes the
/// most prominent line. If the fault's own line is faint and another stands out, returns both: an
/// analyst would have decided differently.
std::string evidence_of(const Verdict& verdict, const signal::DatasetInfo& info);

/// Returns a table for a terminal, at most 80 columns wide, with a row for each recording: the
/// predicted class (or "unknown"), its probability, the shares of windows that agree and that are
/// unknown, and the height of the fault's line in the envelope spectrum. If descriptions give
/// classes, they get a column. Names that are too long lose their beginning.
std::string table_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info);

/// Returns a line for each recording whose shaft certainly turns at another speed than the given
/// one, with what to do; empty if there are none.
std::string speeds_of(const std::vector<Verdict>& verdicts);

/// Returns lines about the classifier, its training set, and its trust, which a network for all
/// machines lacks.
std::string origin_of(const diagnosis::KeptClassifier& kept,
                      const std::optional<diagnosis::Trust>& trust);

/// Returns a line for each window: recording, start_s, class, probability, novelty (column
/// `novelty`), unknown (0 or 1), and the probability of every class.
std::string csv_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info);

}  // namespace piae::classification
