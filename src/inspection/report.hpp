#pragma once

#include <string>

#include "inspection/check.hpp"
#include "signal/description.hpp"

namespace piae::inspection {

/// Returns what `ingest --check` prints: tables, each warning and each problem in a line of its
/// own, and a summary if the recordings can be used.
std::string report_of(const signal::Description& description, const DatasetCheck& check);

}  // namespace piae::inspection
