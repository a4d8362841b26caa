#pragma once

#include <string>

#include "inspection/check.hpp"

namespace piae::inspection {

/// Returns a drawing (SVG) of the recordings, one row for each readable one. Left: the first 0.2 s
/// of the signal about its mean. Right: the envelope spectrum in dB over its own median, with the
/// lines of the three defects and their second and third harmonics marked and named. The lines of
/// the record's own class are thick.
std::string picture_of(const signal::DatasetInfo& info, const DatasetCheck& check);

}  // namespace piae::inspection
