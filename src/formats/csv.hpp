#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// Returns a line for each window: its facts, then its samples as x0, x1, ..., each with the fewest
/// digits that give the same float. Spaces separate several values in a field.
std::string csv(const Exported& exported);

/// Returns the same lines without samples, for formats that hold only samples.
std::string labels_csv(const Exported& exported);

}  // namespace piae::formats
