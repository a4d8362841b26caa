#pragma once

#include <string>
#include <vector>

#include "classification/verdict.hpp"

namespace piae::classification {

/// Draws the recordings (SVG), a row for each. The left side is the time line: the predicted class
/// of each window, one row per class and unknown windows at the bottom; darker is more certain. The
/// right side is the evidence: the envelope spectrum with the fault lines of the bearing, those of
/// the predicted fault thick. Windows are `length` samples long.
std::string picture_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info,
                       std::size_t length);

}  // namespace piae::classification
