#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// A line a window: what is known of it, and then its samples as x0, x1, ..., each by the fewest
/// digits from which the same float is read. Several values in a field stand with spaces between.
std::string csv(const Exported& exported);

/// The same without the samples, for formats that hold nothing else.
std::string labels_csv(const Exported& exported);

}  // namespace piae::formats
