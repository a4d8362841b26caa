#pragma once

#include <string>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

/// Adds a warning if some files of a record differ from most in their number of samples, and
/// another for their number of columns.
void add_odd_files(const RecordCheck& record, std::vector<std::string>& lines);

}  // namespace piae::inspection
