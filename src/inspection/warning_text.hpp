#pragma once

#include <functional>
#include <string>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

// Helpers shared by the warnings.

/// Returns a text such as "IR007 (cwru/105.mat, variable X105_DE_time)".
std::string place_of(const signal::RecordSource& source);

/// Returns a text such as " of acc_2.csv"; empty for a record of one file.
std::string of_file(const RecordCheck& record, const FileCheck& file);

/// Returns a text such as "sample 5"; for a record of several files "sample 5 of acc_2.csv",
/// counted in that file.
std::string sample_text(const RecordCheck& record, std::size_t sample);

/// Returns a text such as "samples 5 to 9", for several files as sample_text() does.
std::string samples_text(const RecordCheck& record, std::size_t first, std::size_t last);

/// Returns a text such as "IR007, OR021".
std::string names_of(const std::vector<const RecordCheck*>& records);

/// Adds a line for each of up to three records. More records share one cause, so only the first
/// gets a line, with the names of the others.
void add_for_each(std::vector<const RecordCheck*> records,
                  const std::function<std::string(const RecordCheck&)>& text,
                  std::vector<std::string>& lines);

}  // namespace piae::inspection
