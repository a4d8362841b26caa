#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "base/label.hpp"
#include "scoring/decisions.hpp"

namespace piae::run {

/// What decisions need of the test windows of a seed (A.h5), which diagnoses do not say.
struct TestedWindows {
  std::vector<Label> labels;  ///< [n]
  scoring::Places places;     ///< [n]
};

/// Those of a run, by seed; a seed of which they are not known is missing.
using TestedWindowsBySeed = std::map<std::int64_t, TestedWindows>;

/// Reads them without the samples. Throws artefact::Refusal where the file is not of this dataset
/// and seed, is no set of test windows, or where a window has no place.
TestedWindows read_tested_windows(const artefact::Reader& reader, const std::string& dataset,
                                  std::int64_t seed);

}  // namespace piae::run
