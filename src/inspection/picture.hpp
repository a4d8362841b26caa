#pragma once

#include <string>

#include "inspection/check.hpp"

namespace piae::inspection {

/// The recordings as a drawing (SVG), a row for each that could be read: on the left the first 0.2
/// s of the signal about its mean, on the right the envelope spectrum in dB over its own median,
/// with the lines of the three defects and their second and third harmonics marked and named; the
/// lines of the record's own class are thick.
std::string picture_of(const signal::DatasetInfo& info, const DatasetCheck& check);

}  // namespace piae::inspection
