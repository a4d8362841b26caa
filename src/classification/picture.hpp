#pragma once

#include <string>
#include <vector>

#include "classification/verdict.hpp"

namespace piae::classification {

/// The recordings as a drawing (SVG), a row for each. On the left the time line: which class each
/// window is named, a row a class, and unknown ones at the bottom; the darker, the surer. On the
/// right the evidence: the envelope spectrum with the fault lines of the bearing, those of the
/// named fault thick. Windows are `length` samples long.
std::string picture_of(const std::vector<Verdict>& verdicts, const signal::DatasetInfo& info,
                       std::size_t length);

}  // namespace piae::classification
