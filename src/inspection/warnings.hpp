#pragma once

#include <string>
#include <vector>

#include "inspection/check.hpp"
#include "signal/description.hpp"

namespace piae::inspection {

/// Returns the oddities of a description and its recordings, one line each: where (key of the
/// description; record, file and variable), what, and why it matters. Each may be intended, and
/// none stops the grid. Consequences of another oddity are not repeated: a record with a speed that
/// looks like Hz or contradicts its shaft, or without vibration, is not searched for fault lines.
std::vector<std::string> warnings_of(const signal::Description& description,
                                     const DatasetCheck& check);

/// Returns the problems of records and classes, one line each. They stop the grid.
std::vector<std::string> problems_of(const DatasetCheck& check);

/// Returns the oddities in the samples of one record: a time instead of a vibration, clipped peaks,
/// few distinct values, stretches of one value, spikes, repeated stretches, missing samples, a last
/// number that may be cut off, and times that go back, step unevenly or contradict the rate. A
/// time, or few values, is reported alone.
std::vector<std::string> sample_warnings(const RecordCheck& record);

/// Returns the oddities in fault lines: a faulty record without the line of its class, or with a
/// stronger line of another defect, and a healthy record with a line. If three quarters of the
/// faulty records are odd, returns a single line instead. The same if their lines are off by one
/// factor.
std::vector<std::string> line_warnings(const signal::DatasetInfo& info,
                                       const std::vector<RecordCheck>& records);

}  // namespace piae::inspection
