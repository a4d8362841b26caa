#pragma once

#include <string>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

/// Adds a line where files of a record of many differ from most of them in their number of samples,
/// and one where they do in their number of columns.
void add_odd_files(const RecordCheck& record, std::vector<std::string>& lines);

}  // namespace piae::inspection
