#pragma once

#include <string>
#include <vector>

#include "inspection/check.hpp"
#include "signal/description.hpp"

namespace piae::inspection {

/// What is odd about a description and its recordings, one line each: where it is (key of the
/// description; record, file and variable), what it is, and why it matters. Each can be meant so,
/// and none keeps the grid from running. What follows from another oddity is not said again: a
/// record whose speed looks like Hz or that is no vibration is not asked for its fault lines.
std::vector<std::string> warnings_of(const signal::Description& description,
                                     const DatasetCheck& check);

/// The problems of records and classes, one line each: they keep the grid from running.
std::vector<std::string> problems_of(const DatasetCheck& check);

/// Returns what is odd about the samples of one record: a time instead of a vibration, clipped
/// peaks, few distinct values, stretches of one value, samples that stand alone, stretches that
/// repeat, and missing samples.
std::vector<std::string> sample_warnings(const RecordCheck& record);

/// What is odd about fault lines alone: a record that does not show the line of its class, or shows
/// that of another defect farther, and a healthy record that shows one. Where three quarters of the
/// faulty records do not, that alone is said, once; and the factor, where their lines are off by
/// the same one.
std::vector<std::string> line_warnings(const signal::DatasetInfo& info,
                                       const std::vector<RecordCheck>& records);

}  // namespace piae::inspection
