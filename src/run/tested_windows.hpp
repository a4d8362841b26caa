#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "base/label.hpp"
#include "scoring/decisions.hpp"

namespace piae::run {

/// Facts about the test windows of a seed (A.h5) that decisions need and diagnoses do not store.
struct TestedWindows {
  std::vector<Label> labels;  ///< [n]
  scoring::Places places;     ///< [n]
};

/// Test windows of a run by seed; seeds without known test windows are absent.
using TestedWindowsBySeed = std::map<std::int64_t, TestedWindows>;

/// Reads the test windows without their samples. Throws artefact::Refusal if the file belongs to
/// another data set or seed, is not a set of test windows, or has a window without a place.
TestedWindows read_tested_windows(const artefact::Reader& reader, const std::string& dataset,
                                  std::int64_t seed);

}  // namespace piae::run
